//! How planets share the load: by symmetry where there is one, by linear theory where pins are out of place.
