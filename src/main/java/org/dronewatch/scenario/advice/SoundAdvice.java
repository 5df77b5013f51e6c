package org.dronewatch.scenario.advice;

import java.util.Locale;
import java.util.function.Consumer;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.sound.Directivity;
import org.dronewatch.sound.DroneSounds;

/**
 * Warns about a drone's sound that combines measured and other data: the spectrum is that of a measured drone, but the
 * directivity or the sound power level is not.
 *
 * @param id name of the drone
 * @param drone settings of the drone
 */
public record SoundAdvice(String id, DroneSettings drone) {
    /** Drones of one kind differ by a few decibels from flight to flight. */
    private static final double USUAL_SPREAD = 6.0;

    /** Gives one line for each such combination. */
    public void giveTo(Consumer<String> target) {
        if (drone.spectrum().isPresent()) {
            return;
        }
        DroneSounds.measuredDirectivity(drone.sound()).ifPresent(measured -> {
            double level = DroneSounds.get(drone.sound()).level();
            if (drone.directivity().equals(Directivity.OMNIDIRECTIONAL)) {
                target.accept(String.format(
                        Locale.ROOT,
                        "drone '%1$s' has the sound of %2$s but radiates it equally in all directions: the measured drone has"
                                + " 'directivity: %2$s'",
                        id,
                        drone.sound()));
            }
            if (Math.abs(drone.soundPowerLevel() - level) > USUAL_SPREAD) {
                target.accept(String.format(
                        Locale.ROOT,
                        "drone '%s' has the sound of %s at %.1f dB: the measured drone had %.1f dB",
                        id,
                        drone.sound(),
                        drone.soundPowerLevel(),
                        level));
            }
        });
    }
}
