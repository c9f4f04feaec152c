//! Power flow of gear trains for the report of a run. The trains are solved in Calyx
//! (`calyx/gear_train.cx`).

use crate::externs::host;

/// Rotors and connections of a gear train with the power that they transmit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PowerFlow {
    /// The rotors.
    pub rotors: Vec<RotorPower>,
    /// The connections.
    pub connections: Vec<ConnectionPower>,
}

/// A rotor of a gear train.
#[derive(Clone, Debug, PartialEq)]
pub struct RotorPower {
    /// Name.
    pub name: String,
    /// Name of its carrier; empty for ground.
    pub carrier: String,
    /// Speed relative to the carrier, or to ground, rad/s.
    pub speed: f64,
    /// External torque, N m.
    pub torque: f64,
}

/// A connection of two rotors.
#[derive(Clone, Debug, PartialEq)]
pub struct ConnectionPower {
    /// Name.
    pub name: String,
    /// Kind, such as "external mesh".
    pub kind: String,
    /// Names of both rotors.
    pub rotors: [String; 2],
    /// Power from the first to the second rotor in ground coordinates, before losses, W.
    pub power: f64,
    /// Power loss, W.
    pub loss: f64,
    /// True in a closed loop, where the power depends on the stiffness of teeth and shafts, and is
    /// distributed equally among equal planets and paths.
    pub is_assumed: bool,
}

calyx_abi::externs! {
    Scene fn calyx_gear_train_record_power_flow(
        context, names: Vec<String>, carriers: Vec<String>, speeds: Vec<f64>, torques: Vec<f64>,
        connections: Vec<String>, kinds: Vec<String>, first: Vec<String>, second: Vec<String>,
        powers: Vec<f64>, losses: Vec<f64>, assumed: Vec<String>,
    ) -> () {
        let rotors = names.into_iter().zip(carriers).zip(speeds.into_iter().zip(torques));
        let ends = first.into_iter().zip(second);
        let connections = connections.into_iter().zip(kinds).zip(ends).zip(powers.into_iter().zip(losses));
        host(context)?.power_flows.push(PowerFlow {
            rotors: rotors
                .map(|((name, carrier), (speed, torque))| RotorPower { name, carrier, speed, torque })
                .collect(),
            connections: connections
                .map(|(((name, kind), (first, second)), (power, loss))| {
                    let is_assumed = assumed.contains(&name);
                    ConnectionPower { name, kind, rotors: [first, second], power, loss, is_assumed }
                })
                .collect(),
        });
        Ok(())
    }
}
