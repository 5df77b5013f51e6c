package org.dronewatch.examples;

import org.dronewatch.drone.Drone;
import org.dronewatch.drone.SoundEmission;
import org.dronewatch.drone.SteadyEmission;
import org.dronewatch.setting.Defaults;
import org.dronewatch.sound.BandLevels;

/**
 * The sound of a drone that is louder the faster it flies.
 *
 * @param perSpeed by how much louder for each m/s above the drone's cruise speed, dB
 */
public record Hum(double perSpeed) implements SoundEmission {
    @Defaults
    public static final Hum DEFAULT = new Hum(2.0);

    /** Sound power levels of the octave bands, for the energy model. */
    @Override
    public BandLevels soundPower(Drone drone) {
        return SteadyEmission.DEFAULT.soundPower(drone).plus(gain(drone));
    }

    /** The level for the level model. */
    @Override
    public double soundLevel(Drone drone) {
        return SteadyEmission.DEFAULT.soundLevel(drone) + gain(drone);
    }

    private double gain(Drone drone) {
        return perSpeed * (drone.velocity().length() - drone.settings().speed());
    }
}
