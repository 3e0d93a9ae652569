//! Loads a library from the shipped files and a user's; a broken file of the user's is set aside.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use saute_food::{FoodDescription, Scale};
use saute_heat::Soup;

use crate::data::at_home::{AT_HOME_FILE, DEFAULT_HOB, KitchenAtHome};
use crate::data::data_hash::file_hashes;
use crate::data::goals::{GoalDescription, GoalsFile};
use crate::data::library::{DonenessFile, Library, with_body};
use crate::data::room::Room;
use crate::data::shelf::{Shelved, shipped_files};
use crate::pan::hob::HobDescription;
use crate::pan::pan_description::{CoatingDescription, PanDescription};
use saute_schema::{DataFile, LibraryError};

/// The file of the scales of doneness.
const DONENESS_FILE: &str = "doneness.toml";

/// The file of the goals.
const GOALS_FILE: &str = "goals.toml";

/// The file of what juice leaves on the pan.
const FOND_FILE: &str = "fond.toml";

/// The cause for which an entry is set aside, where its own file is broken. The error of that file states more.
const ITS_FILE: &str = "its file in the --data folder is broken";

/// Files of a user, which are added to the shipped ones or replace those of the same path.
#[derive(Clone, Debug, Default)]
pub struct OwnFiles {
    /// Texts by path, as `foods/my-steak.toml`, `pans/…`, `recipes/…`, `kinetics/…` or `doneness.toml`.
    pub texts: BTreeMap<String, String>,
    /// Triangles of the surfaces that foods name, by the path of the food's file.
    pub surfaces: BTreeMap<String, Soup>,
    /// Paths of files that are there but cannot be read, or whose surface cannot.
    pub unreadable: BTreeSet<String>,
}

/// A library that is being loaded.
pub(crate) struct Loading<'a> {
    own: &'a OwnFiles,
    files: BTreeMap<String, String>,
    set_aside: BTreeMap<String, String>,
    faults: Vec<LibraryError>,
}

impl<'a> Loading<'a> {
    pub(crate) fn new(own: &'a OwnFiles) -> Self {
        let mut files = shipped_files().clone();
        files.extend(own.texts.iter().map(|(path, text)| (path.clone(), text.clone())));
        files.retain(|path, _| !own.unreadable.contains(path));
        let set_aside = own.unreadable.iter().map(|path| (path.clone(), ITS_FILE.to_owned())).collect();
        Self { own, files, set_aside, faults: Vec::new() }
    }

    /// Returns the library and the errors of the user's files.
    pub(crate) fn library(mut self) -> Result<(Library, Vec<LibraryError>), LibraryError> {
        let bare = self.folder("pans/")?;
        let coatings = self.folder("coatings/")?;
        let room: Room = self.parse("kitchen.toml")?;
        let hobs: BTreeMap<String, HobDescription> = self.folder("hobs/")?;
        let mut library = Library {
            foods: self.folder("foods/")?,
            kinetics: self.folder("kinetics/")?,
            pans: with_coatings(&bare, &coatings),
            oils: self.folder("oils/")?,
            recipes: in_folder(&self.files, "recipes/").map(|(id, text)| (id.to_owned(), text.clone())).collect(),
            scales: self.scales()?,
            goals: self.goals()?,
            components: self.parse("components.toml")?,
            typical: Arc::new(room.clone()),
            room,
            hob: self.any_hob(&hobs)?,
            hobs,
            at_home: KitchenAtHome::default(),
            home: None,
            fond: self.parse(FOND_FILE)?,
            set_aside: BTreeMap::new(),
            hashes: file_hashes(&self.files, &self.own.surfaces),
        };
        self.set_coated_aside(&library.pans, &coatings);
        self.settle_at_home(&mut library)?;
        self.settle_oils(&mut library)?;
        self.settle_foods(&mut library)?;
        library.set_aside.clone_from(&self.set_aside);
        self.settle_scales(&mut library)?;
        self.settle_own_scales(&mut library)?;
        self.settle_goals(&mut library)?;
        library.set_aside = self.set_aside;
        Ok((library, self.faults))
    }

    /// Sets an entry aside because of an error. Without files of the user's, the error is one of the program.
    fn fault(&mut self, path: &str, error: LibraryError) -> Result<(), LibraryError> {
        if self.own.texts.is_empty() && self.own.unreadable.is_empty() {
            return Err(error);
        }
        self.faults.push(error);
        self.set_aside.insert(path.to_owned(), ITS_FILE.to_owned());
        Ok(())
    }

    fn file<'f>(&'f self, name: &'f str) -> DataFile<'f> {
        DataFile { name, text: self.files.get(name).map_or("", String::as_str) }
    }

    fn parse<T: Shelved>(&self, path: &str) -> Result<T, LibraryError> {
        T::shelf().read(&self.file(path))
    }

    /// Reads and checks every file of a folder, by id.
    fn folder<T: Shelved>(&mut self, folder: &str) -> Result<BTreeMap<String, T>, LibraryError> {
        let read = |(id, text): (&str, &String)| {
            let path = format!("{folder}{id}.toml");
            let read = T::shelf().read(&DataFile { name: &path, text });
            (id.to_owned(), path, read)
        };
        let all: Vec<(String, String, Result<T, LibraryError>)> = in_folder(&self.files, folder).map(read).collect();
        let mut sound = BTreeMap::new();
        for (id, path, read) in all {
            match read {
                Ok(entry) => drop(sound.insert(id, entry)),
                Err(error) => self.fault(&path, error)?,
            }
        }
        Ok(sound)
    }

    fn scales(&mut self) -> Result<Vec<Arc<Scale>>, LibraryError> {
        if self.set_aside.contains_key(DONENESS_FILE) {
            return Ok(Vec::new());
        }
        match self.parse::<DonenessFile>(DONENESS_FILE) {
            Ok(parsed) => Ok(parsed.scale.into_iter().map(Arc::new).collect()),
            Err(error) => self.fault(DONENESS_FILE, error).map(|()| Vec::new()),
        }
    }

    fn goals(&mut self) -> Result<Vec<Arc<GoalDescription>>, LibraryError> {
        if self.set_aside.contains_key(GOALS_FILE) {
            return Ok(Vec::new());
        }
        match self.parse::<GoalsFile>(GOALS_FILE) {
            Ok(parsed) => Ok(parsed.goal.into_iter().map(Arc::new).collect()),
            Err(error) => self.fault(GOALS_FILE, error).map(|()| Vec::new()),
        }
    }

    /// Sets aside the coated pans of which the pan or the coating is set aside.
    fn set_coated_aside(
        &mut self,
        pans: &BTreeMap<String, PanDescription>,
        coatings: &BTreeMap<String, CoatingDescription>,
    ) {
        let broken =
            |folder: &str| -> Vec<String> { in_folder(&self.set_aside, folder).map(|(id, _)| id.to_owned()).collect() };
        let (broken_pans, broken_coatings) = (broken("pans/"), broken("coatings/"));
        let all = |sound: Vec<&String>, broken: &[String]| -> Vec<String> {
            sound.into_iter().chain(broken).cloned().collect()
        };
        let every_coating = all(coatings.keys().collect(), &broken_coatings);
        let of_pans = broken_pans.iter().flat_map(|pan| every_coating.iter().map(move |c| format!("{pan}-{c}")));
        let of_coatings = pans.keys().flat_map(|pan| broken_coatings.iter().map(move |c| format!("{pan}-{c}")));
        let coated: Vec<String> = of_pans.chain(of_coatings).filter(|id| !pans.contains_key(id)).collect();
        for id in coated {
            let cause = "the file of its pan or of its coating in the --data folder is broken";
            self.set_aside.entry(format!("pans/{id}.toml")).or_insert_with(|| cause.to_owned());
        }
    }

    /// Sets what a kitchen at home has otherwise. Where its file is broken, nothing can be cooked: all pans are set aside.
    fn settle_at_home(&mut self, library: &mut Library) -> Result<(), LibraryError> {
        let read = match self.set_aside.contains_key(AT_HOME_FILE) {
            true => Ok(None),
            false => self.parse::<KitchenAtHome>(AT_HOME_FILE).map(Some),
        };
        match read {
            Ok(Some(at_home)) => {
                if let Err(cause) = library.settle(&at_home) {
                    let error = self.file(AT_HOME_FILE).error("hob", cause);
                    self.fault(AT_HOME_FILE, error)?;
                    self.set_pans_aside(library);
                    return Ok(());
                }
                library.at_home = at_home;
                let text = self.files.get(AT_HOME_FILE).filter(|text| shipped_files().get(AT_HOME_FILE) != Some(text));
                library.home = text.map(|text| Arc::from(text.as_str()));
                return Ok(());
            }
            Ok(None) => {}
            Err(error) => self.fault(AT_HOME_FILE, error)?,
        }
        self.set_pans_aside(library);
        Ok(())
    }

    /// Sets all pans aside because of the file of the kitchen at home.
    fn set_pans_aside(&mut self, library: &mut Library) {
        let cause = format!("the file {AT_HOME_FILE} in the --data folder is broken");
        for id in std::mem::take(&mut library.pans).into_keys() {
            self.set_aside.entry(format!("pans/{id}.toml")).or_insert_with(|| cause.clone());
        }
    }

    /// Returns the program's hob, on which is cooked unless the kitchen at home names another.
    fn any_hob(&self, hobs: &BTreeMap<String, HobDescription>) -> Result<HobDescription, LibraryError> {
        let path = format!("hobs/{DEFAULT_HOB}.toml");
        match hobs.get(DEFAULT_HOB) {
            Some(hob) => Ok(hob.clone()),
            None => HobDescription::shelf().read(&DataFile { name: &path, text: &shipped_files()[&path] }),
        }
    }

    /// Sets aside a butter of the user's that does not melt; without it no pan can be filled. An oil that is set aside may be
    /// missing, one that no file describes may not.
    fn settle_oils(&mut self, library: &mut Library) -> Result<(), LibraryError> {
        library.set_aside.clone_from(&self.set_aside);
        let Err(error) = library.check_oils() else { return Ok(()) };
        let oil = &library.room.oil;
        let missing =
            [&oil.default, &oil.rendered, &oil.butter].into_iter().filter(|id| !library.oils.contains_key(*id));
        let paths: Vec<String> = missing.map(|id| format!("oils/{id}.toml")).collect();
        if paths.iter().any(|path| library.set_aside(path).is_none()) {
            return Err(error);
        }
        if paths.is_empty() {
            let butter = oil.butter.clone();
            self.fault(&format!("oils/{butter}.toml"), error)?;
            library.oils.remove(&butter);
        }
        Ok(())
    }

    /// Gives the foods their bodies and checks their kinetics.
    fn settle_foods(&mut self, library: &mut Library) -> Result<(), LibraryError> {
        for (id, food) in std::mem::take(&mut library.foods) {
            let path = format!("foods/{id}.toml");
            if self.set_aside.contains_key(&format!("kinetics/{}.toml", food.kinetics)) {
                let cause = format!("the file of its kinetics \"{}\" in the --data folder is broken", food.kinetics);
                self.set_aside.insert(path, cause);
                continue;
            }
            match self.settled(food, &path, library) {
                Ok(food) => drop(library.foods.insert(id, food)),
                Err(error) => self.fault(&path, error)?,
            }
        }
        Ok(())
    }

    fn settled(&self, food: FoodDescription, path: &str, library: &Library) -> Result<FoodDescription, LibraryError> {
        let file = self.file(path);
        let food = with_body(food, self.own.surfaces.get(path), &file)?;
        library.check_kinetics(&food, &file)?;
        Ok(food)
    }

    fn settle_scales(&mut self, library: &mut Library) -> Result<(), LibraryError> {
        if let Err(error) = library.check_scales(&self.file(DONENESS_FILE)) {
            self.fault(DONENESS_FILE, error)?;
            library.scales.clear();
        }
        Ok(())
    }

    /// Adds the scales that foods state for themselves. A food whose scale cannot be used is set aside.
    fn settle_own_scales(&mut self, library: &mut Library) -> Result<(), LibraryError> {
        let own = library.foods.iter().filter_map(|(id, food)| Some((id.clone(), food.doneness.clone()?)));
        for (id, scale) in own.collect::<Vec<_>>() {
            let path = format!("foods/{id}.toml");
            match library.check_own_scale(&library.foods[&id], &scale, &self.file(&path)) {
                Ok(()) => library.scales.push(Arc::new(Scale { is_of_one_food: true, ..scale })),
                Err(error) => {
                    library.foods.remove(&id);
                    self.fault(&path, error)?;
                }
            }
        }
        Ok(())
    }

    /// Sets the user's goals aside if one cannot be judged. A shipped goal for whose class the user's scales have no name goes alone.
    fn settle_goals(&mut self, library: &mut Library) -> Result<(), LibraryError> {
        if !self.own.texts.contains_key(GOALS_FILE) && self.own.texts.contains_key(DONENESS_FILE) {
            let scales = &library.scales;
            library.goals.retain(|goal| scales.iter().any(|scale| goal.is_on(scale)));
        }
        if let Err(error) = library.check_goals(&self.file(GOALS_FILE)) {
            self.fault(GOALS_FILE, error)?;
            library.goals.clear();
        }
        Ok(())
    }
}

fn in_folder<'a>(files: &'a BTreeMap<String, String>, folder: &'a str) -> impl Iterator<Item = (&'a str, &'a String)> {
    files.iter().filter_map(move |(path, text)| Some((path.strip_prefix(folder)?.strip_suffix(".toml")?, text)))
}

/// Returns the pans and, for each coating, the pans with it.
fn with_coatings(
    bare: &BTreeMap<String, PanDescription>,
    coatings: &BTreeMap<String, CoatingDescription>,
) -> BTreeMap<String, PanDescription> {
    let mut pans = bare.clone();
    for (id, pan) in bare {
        for (coating_id, coating) in coatings {
            let mut coated = pan.clone();
            coated.name = format!("{}, {}", pan.name, coating.name);
            coated.coating_w_m2k = Some(coating.conductance_w_m2k);
            coated.surface.emissivity = coating.emissivity;
            coated.surface.film_g = 0.0;
            coated.look = coating.look.clone();
            coated.heat_tint = coating.heat_tint.clone();
            pans.entry(format!("{id}-{coating_id}")).or_insert(coated);
        }
    }
    pans
}
