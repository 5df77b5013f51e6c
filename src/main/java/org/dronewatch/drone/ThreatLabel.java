package org.dronewatch.drone;

import java.math.BigDecimal;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.setting.Choices;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * The role, purpose and properties of a drone, for readers of the results. No sensor uses it: it changes no detection.
 *
 * @param role its role in the scene
 * @param purpose intention of its owner
 * @param platform type of aircraft
 * @param powerSource source of its power
 * @param weight take-off weight, above 0 and at most 10,000 kg
 * @param size largest dimension of the real drone, above 0 and at most 100 m; sensors see the model
 */
public record ThreatLabel(
        Role role,
        Purpose purpose,
        Platform platform,
        PowerSource powerSource,
        @In(value = Quantity.MASS, above = 0, to = 10_000) Optional<Double> weight,
        @In(value = Quantity.LENGTH, above = 0, to = 100) Optional<Double> size) {
    /** An attack, with nothing else known. */
    @Defaults
    public static final ThreatLabel DEFAULT = new ThreatLabel(
            Role.ATTACK, Purpose.UNKNOWN, Platform.UNKNOWN, PowerSource.UNKNOWN, Optional.empty(), Optional.empty());

    /** A bird, with nothing else known. */
    public static final ThreatLabel BIRD = new ThreatLabel(
            Role.BIRD, Purpose.UNKNOWN, Platform.UNKNOWN, PowerSource.UNKNOWN, Optional.empty(), Optional.empty());

    /** The role of a drone. */
    public enum Role {
        /** The threat that the site must detect. */
        ATTACK,
        /** A decoy, which draws attention away from others. */
        DECOY,
        /** A harmless drone that passes by. */
        BYSTANDER,
        /** A bird, not a drone: an alert for it is a false alert. */
        BIRD
    }

    /** The intention of a drone's owner. */
    public enum Purpose {
        /** Not known. */
        UNKNOWN,
        /** Reconnaissance. */
        SURVEILLANCE,
        /** Delivery or collection of contraband. */
        SMUGGLING,
        /** Disruption of operations, such as air traffic. */
        DISRUPTION,
        /** Destruction. */
        STRIKE,
        /** Theft of intellectual property. */
        ESPIONAGE,
        /** Harassment of people. */
        HARASSMENT
    }

    /** A type of aircraft. */
    public enum Platform {
        /** Not known. */
        UNKNOWN,
        /** An aircraft with several rotors. */
        MULTIROTOR,
        /** An aircraft with a wing and a motor. */
        FIXED_WING,
        /** An aircraft with a wing, but without a running motor. */
        GLIDER,
        /** A small, fast multirotor that is flown in first-person view (FPV). */
        FPV,
        /** An aircraft with one main rotor. */
        HELICOPTER,
        /** An aircraft with rotors for climbing and a wing for cruising. */
        HYBRID
    }

    /**
     * A power source, as classified in section 2.1.3 of the master's thesis on which this project is based:
     * <cite>Critical Infrastructure Protection Against Attacks Using Drones</cite>, Czech Technical University in
     * Prague, 2018.
     */
    public enum PowerSource {
        /** Not known. */
        UNKNOWN,
        /** A battery. */
        BATTERY,
        /** A combustion engine. */
        FUEL,
        /** A fuel cell. */
        FUEL_CELL,
        /** Solar cells. */
        SOLAR
    }

    /** Checks the limits, and that all components are present. */
    public ThreatLabel {
        Limits.check(ThreatLabel.class, role, purpose, platform, powerSource, weight, size);
    }

    /** The label as text, such as {@code attack, strike, fixed-wing, battery, 5 kg, 1.5 m}. */
    public String inWords() {
        Stream<String> words = Stream.of(role, purpose, platform, powerSource)
                .filter(part -> !part.name().equals(Purpose.UNKNOWN.name()))
                .map(part -> Choices.name(part.name()));
        Stream<String> measures = Stream.concat(
                weight.stream().map(kg -> number(kg) + " kg"), size.stream().map(metres -> number(metres) + " m"));
        return Stream.concat(words, measures).collect(Collectors.joining(", "));
    }

    private static String number(double value) {
        return BigDecimal.valueOf(value).stripTrailingZeros().toPlainString();
    }
}
