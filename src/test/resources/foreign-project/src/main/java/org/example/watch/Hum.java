package org.example.watch;

import java.util.Arrays;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.SoundEmission;
import org.dronewatch.drone.SteadyEmission;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.OctaveBands;

/**
 * All sound in one octave band, and louder the faster the drone flies.
 *
 * @param band 0 for 63 Hz to 7 for 8 kHz
 * @param perSpeed by how much louder for each m/s above the drone's cruise speed, dB
 */
public record Hum(
        @In(value = Quantity.NUMBER, from = 0, to = 7) int band,
        @In(value = Quantity.LEVEL, from = 0.0, to = 20.0) double perSpeed)
        implements SoundEmission {
    @Defaults
    public static final Hum DEFAULT = new Hum(4, 2.0);

    public Hum {
        Limits.check(Hum.class, band, perSpeed);
    }

    @Override
    public BandLevels soundPower(Drone drone) {
        double[] levels = new double[OctaveBands.COUNT];
        Arrays.fill(levels, -BandLevels.MOST);
        levels[band] = drone.settings().soundPowerLevel() - OctaveBands.aWeight(band) + gain(drone);
        return BandLevels.of(levels);
    }

    @Override
    public double soundLevel(Drone drone) {
        return SteadyEmission.DEFAULT.soundLevel(drone) + gain(drone);
    }

    private double gain(Drone drone) {
        return perSpeed * (drone.velocity().length() - drone.settings().speed());
    }
}
