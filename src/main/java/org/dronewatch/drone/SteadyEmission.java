package org.dronewatch.drone;

import java.util.List;
import org.dronewatch.setting.Defaults;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.Tone;

/** The sound that the settings state, however the drone flies; with the motors off, it is quieter and has no tones. */
public record SteadyEmission() implements SoundEmission {
    /** The only instance. */
    @Defaults
    public static final SteadyEmission DEFAULT = new SteadyEmission();

    @Override
    public boolean isStatedBySettings() {
        return true;
    }

    @Override
    public BandLevels soundPower(Drone drone) {
        return BandLevels.of(drone.settings().soundPower(drone.settings().soundPowerLevel() - quieter(drone)));
    }

    @Override
    public double soundLevel(Drone drone) {
        return drone.settings().soundLevel() - quieter(drone);
    }

    @Override
    public List<Tone> tones(Drone drone) {
        return drone.isPowered()
                ? drone.settings().tones().map(RotorTones::lines).orElse(List.of())
                : List.of();
    }

    private static double quieter(Drone drone) {
        return drone.isPowered() ? 0.0 : drone.settings().glideReduction();
    }
}
