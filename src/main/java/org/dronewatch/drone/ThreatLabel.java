package org.dronewatch.drone;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Limits;

/**
 * What a drone means to the site, for readers of the results. No sensor uses it: it changes no detection.
 *
 * @param role its role in the scene
 * @param purpose what its owner wants
 * @param platform how it is built
 */
public record ThreatLabel(Role role, Purpose purpose, Platform platform) {
    /** An attack of which nothing else is known. */
    @Defaults
    public static final ThreatLabel DEFAULT = new ThreatLabel(Role.ATTACK, Purpose.UNKNOWN, Platform.UNKNOWN);

    /** The role of a drone. */
    public enum Role {
        /** The threat that the site must detect. */
        ATTACK,
        /** A decoy, which draws attention away from others. */
        DECOY,
        /** A harmless drone that passes by. */
        BYSTANDER
    }

    /** What the owner of a drone wants. */
    public enum Purpose {
        /** Not known. */
        UNKNOWN,
        /** Reconnaissance. */
        SURVEILLANCE,
        /** Delivery or collection of contraband. */
        SMUGGLING,
        /** Disruption of operations, such as air traffic. */
        DISRUPTION,
        /** To destroy. */
        STRIKE
    }

    /** How a drone is built. */
    public enum Platform {
        /** Not known. */
        UNKNOWN,
        /** With several rotors. */
        MULTIROTOR,
        /** With a wing and a motor. */
        FIXED_WING,
        /** With a wing, and without a motor that runs. */
        GLIDER,
        /** A small fast multirotor that is flown by first-person view (FPV). */
        FPV,
        /** With one main rotor. */
        HELICOPTER
    }

    /** Checks that no component is missing. */
    public ThreatLabel {
        Limits.check(ThreatLabel.class, role, purpose, platform);
    }
}
