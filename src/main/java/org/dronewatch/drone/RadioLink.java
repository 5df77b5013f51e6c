package org.dronewatch.drone;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * A drone's control link, and the radio signals that can be received from it. A drone that flies autonomously, or on a
 * fibre, transmits nothing.
 *
 * @param control type of control
 * @param frequency carrier frequency, 1e6 to 1e11 Hz (1 MHz to 100 GHz)
 * @param power equivalent isotropic radiated power of the drone, -100 to 100 dBm
 * @param pilot position of the pilot's transmitter, m; omit it if that transmitter cannot be received
 * @param pilotPower equivalent isotropic radiated power of the pilot's transmitter, -100 to 100 dBm
 * @param emission type of signal, by which a receiver can recognise it as a drone's
 * @param bursts bursts and hops of the transmission; omit it for a transmission without pauses on one channel
 */
public record RadioLink(
        Control control,
        @In(value = Quantity.FREQUENCY, from = 1e6, to = 1e11) double frequency,
        @In(value = Quantity.LEVEL, from = -100, to = 100) double power,
        Optional<Position> pilot,
        @In(value = Quantity.LEVEL, from = -100, to = 100) double pilotPower,
        @Minor Emission emission,
        @Minor Optional<Bursts> bursts) {
    /** Remote control at 2.4 GHz, 20 dBm from the drone; the pilot's transmitter cannot be received. */
    @Defaults
    public static final RadioLink DEFAULT =
            new RadioLink(Control.RADIO, 2.4e9, 20.0, Optional.empty(), 20.0, Emission.DEDICATED, Optional.empty());

    /** A type of control of a drone. */
    public enum Control {
        /** A pilot who controls the drone by radio, and to whom the drone sends video and telemetry. */
        RADIO,
        /** No pilot: the drone flies as programmed, and transmits nothing. */
        AUTONOMOUS,
        /**
         * A pilot who controls the drone over an optical fibre that the drone pays out as it flies; it transmits
         * nothing, either.
         */
        FIBRE
    }

    /** A type of signal that a drone and its pilot transmit. */
    public enum Emission {
        /** The signal of a remote control or a video link made for drones. */
        DEDICATED,
        /** A WLAN signal, which identifies the drone's manufacturer. */
        WLAN,
        /** The signal of a phone on a mobile network (LTE, 5G); nothing distinguishes it from those of other phones. */
        CELLULAR
    }

    /** Checks the limits. */
    public RadioLink {
        Limits.check(RadioLink.class, control, frequency, power, pilot, pilotPower, emission, bursts);
    }

    /** This link with another type of control. */
    public RadioLink withControl(Control other) {
        return SettingsForm.with(this, "control", other);
    }

    /** This link with another carrier, Hz. */
    public RadioLink withFrequency(double hertz) {
        return SettingsForm.with(this, "frequency", hertz);
    }

    /** This link with another power of the drone, dBm. */
    public RadioLink withPower(double dbm) {
        return SettingsForm.with(this, "power", dbm);
    }

    /** This link with a pilot at a position, m. */
    public RadioLink withPilot(Position position) {
        return SettingsForm.with(this, "pilot", Optional.of(position));
    }

    /** This link with another type of signal. */
    public RadioLink withEmission(Emission other) {
        return SettingsForm.with(this, "emission", other);
    }

    /** This link with its transmission in bursts. */
    public RadioLink withBursts(Bursts other) {
        return SettingsForm.with(this, "bursts", Optional.of(other));
    }

    /** Whether this link transmits anything that can be received. */
    public boolean emits() {
        return control == Control.RADIO;
    }
}
