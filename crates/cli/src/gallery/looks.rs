//! How every food looks from raw to burnt.

use super::figure::{Book, Eye, Figure, look};

/// Every food at nine moments: raw, four while it fries, flipped, rested, cut, burnt.
pub const LOOKS: Book = Book {
    page: "looks.md",
    opening: "# Every food from raw to burnt\n\nDrawn by `saute gallery --looks`. Row by row: raw, 1 minute, 2 minutes; just before the flip at 4 minutes, just after it, 8\nminutes; rested, cut, and burnt in a pan at 1500 W. Every picture shows a moment of a cook in `gallery/looks/`; the numbers below\nit belong to the same moment.\n",
    folder: "gallery/looks",
    cooks: &COOKS,
    figures: &FIGURES,
};

/// A cook of a food and the one that burns it.
macro_rules! cook {
    ($name:literal) => {
        ($name, include_str!(concat!("../../../../gallery/looks/", $name, ".toml")))
    };
}

const COOKS: [(&str, &str); 14] = [
    cook!("beef-lean"),
    cook!("beef-lean-burnt"),
    cook!("beef-marbled"),
    cook!("beef-marbled-burnt"),
    cook!("beef-patty"),
    cook!("beef-patty-burnt"),
    cook!("shrimp"),
    cook!("shrimp-burnt"),
    cook!("carrot-coin"),
    cook!("carrot-coin-burnt"),
    cook!("carrot-stick"),
    cook!("carrot-stick-burnt"),
    cook!("leek-ring"),
    cook!("leek-ring-burnt"),
];

/// The nine moments of a food.
macro_rules! figure {
    ($kind:literal, $title:literal) => {
        Figure {
            name: $kind,
            title: $title,
            caption: "Raw, 1 min, 2 min; 4 min, flipped, 8 min; rested, cut, burnt.",
            panels: &[
                look($kind, 2.0, Eye::Piece),
                look($kind, 60.0, Eye::Piece),
                look($kind, 120.0, Eye::Piece),
                look($kind, 238.0, Eye::Piece),
                look($kind, 246.0, Eye::Piece),
                look($kind, 478.0, Eye::Piece),
                look($kind, 598.0, Eye::Piece),
                look($kind, 612.0, Eye::Piece),
                look(concat!($kind, "-burnt"), 612.0, Eye::Piece),
            ],
            columns: 3,
        }
    };
}

const FIGURES: [Figure; 7] = [
    figure!("beef-lean", "Lean steak"),
    figure!("beef-marbled", "Marbled steak"),
    figure!("beef-patty", "Ground-beef patty"),
    figure!("shrimp", "Shrimps"),
    figure!("carrot-coin", "Carrot coins"),
    figure!("carrot-stick", "Carrot sticks"),
    figure!("leek-ring", "Leek rings"),
];
