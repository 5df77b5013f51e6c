package org.dronewatch.drone;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * How a drone is controlled, and what of that can be heard by radio. One that flies by itself, or on a fibre, is silent.
 *
 * @param control who controls it, and how
 * @param frequency carrier, 1 MHz to 100 GHz, Hz
 * @param power of the drone's own emission, equivalent isotropic, -100 to 100 dBm
 * @param pilot where the pilot's transmitter stands, or empty when it is not to be heard, m
 * @param pilotPower of the pilot's emission, equivalent isotropic, -100 to 100 dBm
 */
public record RadioLink(
        Control control,
        @In(value = Quantity.FREQUENCY, from = 1e6, to = 1e11) double frequency,
        @In(value = Quantity.LEVEL, from = -100, to = 100) double power,
        Optional<Position> pilot,
        @In(value = Quantity.LEVEL, from = -100, to = 100) double pilotPower) {
    /** Remote control at 2.4 GHz, 20 dBm from the drone; where the pilot stands is not known. */
    @Defaults
    public static final RadioLink DEFAULT = new RadioLink(Control.RADIO, 2.4e9, 20.0, Optional.empty(), 20.0);

    /** Who controls a drone, and how. */
    public enum Control {
        /** A pilot by radio: video and telemetry come back. */
        RADIO,
        /** Nobody: it flies as it was programmed, and is silent. */
        AUTONOMOUS,
        /** A pilot through a fibre that it unwinds: it is silent, too. */
        FIBRE
    }

    /** Checks the limits. */
    public RadioLink {
        Limits.check(RadioLink.class, control, frequency, power, pilot, pilotPower);
    }

    /** This link controlled otherwise. */
    public RadioLink withControl(Control other) {
        return new RadioLink(other, frequency, power, pilot, pilotPower);
    }

    /** This link with another carrier, Hz. */
    public RadioLink withFrequency(double hertz) {
        return new RadioLink(control, hertz, power, pilot, pilotPower);
    }

    /** This link with another power of the drone, dBm. */
    public RadioLink withPower(double dbm) {
        return new RadioLink(control, frequency, dbm, pilot, pilotPower);
    }

    /** This link with a pilot at a place, m. */
    public RadioLink withPilot(Position place) {
        return new RadioLink(control, frequency, power, Optional.of(place), pilotPower);
    }

    /** Whether anything of it can be heard by radio. */
    public boolean emits() {
        return control == Control.RADIO;
    }
}
