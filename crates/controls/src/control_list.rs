//! The panels as a list of controls, for a page that shows them a second time as HTML: the tree for screen readers, in reading
//! order.

use std::collections::BTreeMap;

use accesskit::{Node, NodeId, Role, Toggled, TreeUpdate};
use serde::Serialize;

/// What a control is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum ControlKind {
    /// Pressed.
    Button,
    /// On or off.
    Check,
    /// One of several.
    Radio,
    /// Opens a list.
    Menu,
    /// Contains a number in a range.
    Slider,
    /// Contains a text.
    Text,
    /// Is only read.
    Label,
    /// Names what follows: a part of a card, a card or a panel.
    Heading,
}

/// One of them.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Control {
    /// Its number, as text: scripts do not store it as a number.
    pub id: String,
    /// What it is.
    pub kind: ControlKind,
    /// What it is called.
    pub name: String,
    /// Whether it is on, for those that are on or off.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub on: Option<bool>,
    /// Lowest and highest value, and the present one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub range: Option<[f64; 3]>,
    /// The text that it contains; of a slider its value with the unit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
    /// True if it cannot be used now.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub off: bool,
    /// True if it is on a card or in a menu, over all else.
    #[serde(skip)]
    pub is_over: bool,
}

/// All controls and texts of a tree that have a name, in reading order.
pub fn controls(update: &TreeUpdate) -> Vec<Control> {
    let nodes: BTreeMap<NodeId, &Node> = update.nodes.iter().map(|(id, node)| (*id, node)).collect();
    let mut found = Vec::new();
    let mut waiting: Vec<(NodeId, bool)> = update.tree.iter().map(|tree| (tree.root, false)).collect();
    while let Some((id, is_over)) = waiting.pop() {
        let Some(node) = nodes.get(&id) else { continue };
        let is_over = is_over || node.role() == Role::Dialog;
        waiting.extend(node.children().iter().rev().map(|child| (*child, is_over)));
        found.extend(
            control(id, node, |other| nodes.get(&other).copied()).map(|control| Control { is_over, ..control }),
        );
    }
    found
}

/// Switches off what is under an open card, as the mouse does not reach it either.
pub fn under_card(controls: &mut [Control]) {
    if controls.iter().any(|control| control.is_over) {
        controls.iter_mut().filter(|control| !control.is_over).for_each(|control| control.off = true);
    }
}

/// What identifies a control when the panels have renumbered their controls: they do when what is above them changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Identity {
    id: String,
    kind: ControlKind,
    name: String,
    /// How many of its kind and name are before it.
    number: usize,
}

impl Identity {
    /// Of the control that has an id.
    pub fn of(id: &str, controls: &[Control]) -> Option<Self> {
        let place = controls.iter().position(|control| control.id == id)?;
        let Control { id, kind, name, .. } = controls[place].clone();
        let mut identity = Self { id, kind, name, number: 0 };
        identity.number = controls[..place].iter().filter(|control| identity.is_alike(control)).count();
        Some(identity)
    }

    /// Finds it: by its id if it is still its own, else by kind, name and order.
    pub fn find<'a>(&self, controls: &'a [Control]) -> Option<&'a Control> {
        let mut alike = controls.iter().filter(|control| self.is_alike(control));
        alike.clone().find(|control| control.id == self.id).or_else(|| alike.nth(self.number))
    }

    fn is_alike(&self, control: &Control) -> bool {
        control.kind == self.kind && control.name == self.name
    }
}

/// The control of a node, if it is one with a name: its own, or that of the node that labels it.
fn control<'a>(id: NodeId, node: &'a Node, other: impl Fn(NodeId) -> Option<&'a Node>) -> Option<Control> {
    let kind = kind(node)?;
    let range = (kind == ControlKind::Slider).then(|| range(node)).flatten();
    // What has no range is only read.
    let kind = if kind == ControlKind::Slider && range.is_none() { ControlKind::Label } else { kind };
    let named =
        node.label().or_else(|| node.value().filter(|_| matches!(kind, ControlKind::Label | ControlKind::Heading)));
    let label = |id: &NodeId| other(*id).and_then(|node| node.label().or_else(|| node.value()));
    let named = named.or_else(|| node.labelled_by().iter().find_map(label));
    let name = named.map(str::trim).filter(|name| !name.is_empty())?.to_owned();
    let on = node.toggled().map(|toggled| toggled == Toggled::True);
    let on = on.or_else(|| node.is_selected()).or((kind == ControlKind::Radio).then_some(false));
    let text = match kind {
        ControlKind::Text => Some(node.value().unwrap_or_default().to_owned()),
        ControlKind::Slider => node.value().map(str::to_owned),
        _ => None,
    };
    Some(Control { id: id.0.to_string(), kind, name, on, range, text, off: node.is_disabled(), is_over: false })
}

fn kind(node: &Node) -> Option<ControlKind> {
    Some(match node.role() {
        Role::Button | Role::DefaultButton | Role::Link => ControlKind::Button,
        Role::CheckBox | Role::Switch => ControlKind::Check,
        Role::RadioButton => ControlKind::Radio,
        Role::ComboBox => ControlKind::Menu,
        Role::Slider | Role::SpinButton => ControlKind::Slider,
        Role::TextInput | Role::SearchInput | Role::MultilineTextInput => ControlKind::Text,
        Role::Label | Role::ProgressIndicator => ControlKind::Label,
        Role::Heading | Role::Group => ControlKind::Heading,
        _ => return None,
    })
}

fn range(node: &Node) -> Option<[f64; 3]> {
    Some([node.min_numeric_value()?, node.max_numeric_value()?, node.numeric_value()?])
}

#[cfg(test)]
mod tests {
    use accesskit::{TreeId, TreeInfo};

    use super::*;

    fn node(role: Role, label: &str) -> Node {
        let mut node = Node::new(role);
        node.set_label(label);
        node
    }

    #[test]
    fn a_control_is_found_again_when_the_panels_have_numbered_anew() {
        let list = |controls: &[(u64, Role, &str)]| -> Vec<Control> {
            controls.iter().filter_map(|(id, role, name)| control(NodeId(*id), &node(*role, name), |_| None)).collect()
        };
        let before = list(&[(1, Role::Label, "Save"), (2, Role::Button, "Save"), (3, Role::Button, "Save")]);
        let found = |now: &[(u64, Role, &str)], id| Some(Identity::of(id, &before)?.find(&list(now))?.id.clone());
        let anew = [
            (5, Role::Button, "Recent"),
            (6, Role::Label, "Save"),
            (7, Role::Button, "Save"),
            (8, Role::Button, "Save"),
        ];
        assert_eq!(found(&anew, "2").as_deref(), Some("7"));
        assert_eq!(found(&anew, "3").as_deref(), Some("8"), "the second of a name");
        let partly = [(2, Role::Button, "Recent"), (3, Role::Button, "Save")];
        assert_eq!(found(&partly, "3").as_deref(), Some("3"), "what keeps its number is itself");
        assert_eq!(found(&partly, "2").as_deref(), Some("3"), "a number that another one has is not it");
        assert_eq!(found(&[(2, Role::Button, "Recent")], "2"), None, "it is gone");
    }

    /// Promise: a field has the name of the text beside it, where it has none of its own.
    #[test]
    fn a_field_is_named_by_what_labels_it() {
        let (mut field, label) = (Node::new(Role::TextInput), node(Role::Label, "How many?"));
        assert_eq!(control(NodeId(1), &field, |_| Some(&label)), None, "nothing labels it");
        field.push_labelled_by(NodeId(2));
        let named = control(NodeId(1), &field, |id| (id == NodeId(2)).then_some(&label)).expect("a control");
        assert_eq!((named.name.as_str(), named.kind), ("How many?", ControlKind::Text));
    }

    /// Promise: under an open card nothing is on, and what is on the card stays as it is.
    #[test]
    fn what_lies_under_a_card_is_off() {
        let mut root = Node::new(Role::Window);
        root.set_children(vec![NodeId(2), NodeId(3)]);
        let mut card = Node::new(Role::Dialog);
        card.set_children(vec![NodeId(4), NodeId(5)]);
        let nodes = [
            (1, root),
            (2, node(Role::Button, "Flip")),
            (3, card),
            (4, node(Role::Heading, "Keys")),
            (5, node(Role::Button, "Done")),
        ];
        let update = TreeUpdate {
            nodes: nodes.map(|(id, node)| (NodeId(id), node)).into(),
            tree: Some(TreeInfo::new(NodeId(1))),
            tree_id: TreeId::ROOT,
            focus: NodeId(1),
        };
        let mut found = controls(&update);
        under_card(&mut found);
        let states: Vec<_> = found.iter().map(|control| (control.name.as_str(), control.kind, control.off)).collect();
        let heading = ("Keys", ControlKind::Heading, false);
        assert_eq!(states, [("Flip", ControlKind::Button, true), heading, ("Done", ControlKind::Button, false)]);
    }

    #[test]
    fn controls_come_in_reading_order_with_what_they_hold() {
        let mut root = Node::new(Role::Window);
        root.set_children(vec![NodeId(2), NodeId(3)]);
        let mut panel = Node::new(Role::GenericContainer);
        panel.set_children(vec![NodeId(4), NodeId(5), NodeId(6)]);
        let mut slider = node(Role::Slider, "Power");
        slider.set_min_numeric_value(0.0);
        slider.set_max_numeric_value(2000.0);
        slider.set_numeric_value(800.0);
        let mut label = Node::new(Role::Label);
        label.set_value("Pan 20 °C");
        let mut lid = node(Role::Button, "Lid");
        lid.set_toggled(Toggled::True);
        let mut flip = node(Role::Button, "Flip");
        flip.set_disabled();
        let numbered = |id, node| (NodeId(id), node);
        let update = TreeUpdate {
            nodes: vec![
                numbered(1, root),
                numbered(3, flip),
                numbered(2, panel),
                numbered(6, lid),
                numbered(5, label),
                numbered(4, slider),
            ],
            tree: Some(TreeInfo::new(NodeId(1))),
            tree_id: TreeId::ROOT,
            focus: NodeId(1),
        };
        let found = controls(&update);
        let names: Vec<&str> = found.iter().map(|control| control.name.as_str()).collect();
        assert_eq!(names, ["Power", "Pan 20 °C", "Lid", "Flip"]);
        assert_eq!(found[0].range, Some([0.0, 2000.0, 800.0]));
        assert_eq!((found[1].kind, found[2].on, found[3].off), (ControlKind::Label, Some(true), true));
        assert_eq!(
            serde_json::to_string(&found[2]).expect("is written"),
            r#"{"id":"6","kind":"button","name":"Lid","on":true}"#
        );
    }
}
