//! What networked devices promise: phones, the Inverse3 and OSC senders.

mod chromium;
mod haply;
mod inverse_service;
mod osc;
mod phone;
mod phone_client;
mod phone_page;
mod slow_phones;
