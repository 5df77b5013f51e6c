package org.dronewatch.sensor.acoustic.level;

import java.util.Map;
import java.util.Optional;
import org.dronewatch.sensor.Condition;
import org.dronewatch.sensor.acoustic.propagation.Microphone;
import org.dronewatch.sensor.acoustic.propagation.Propagation;
import org.dronewatch.sensor.acoustic.propagation.SoundTracer;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.World;

/**
 * The level model of sound propagation: every ray carries the drone's full level, which is reduced only by the air and
 * at each surface. It is the model of the thesis on which this project is based; its levels are calibrated, not
 * physical.
 *
 * @param initialRays number of rays that leave the drone in random directions, in addition to one straight to the
 *     sensor; 1 to 100,000
 * @param reflectionsPerHit number of rays that leave a surface for each ray that hits it, 1 to 10,000
 * @param attenuation loss of level in the air, 0 to 1000 dB/m
 * @param maxOrder maximum number of surfaces that a ray may hit before it ends, 0 to 100
 * @param rayBudget maximum number of ray segments of one look, 1 to 50,000,000
 * @param listening {@code fast}: a look ends with the first ray that reaches the threshold; {@code thorough}: a look
 *     traces all rays, and reports the highest level and the cumulative energy
 * @param diffraction fraction of the reflected and of the transmitted energy that is scattered (which the thesis calls
 *     diffraction), 0 to 1; the specular and refracted rays carry the rest; if omitted, all rays carry equal energy.
 *     This affects the cumulative energy, not the levels, which are not divided among the rays
 * @param transmittedRays number of rays from the far side of a wall that transmits sound, 1 to 10,000: one refracted,
 *     the others scattered
 */
public record LevelModel(
        @In(value = Quantity.NUMBER, from = 1, to = 100_000) int initialRays,
        @In(value = Quantity.NUMBER, from = 1, to = 10_000) int reflectionsPerHit,
        @In(value = Quantity.ATTENUATION, from = 0, to = 1000) double attenuation,
        @In(value = Quantity.NUMBER, from = 0, to = 100) int maxOrder,
        @In(value = Quantity.NUMBER, from = 1, to = 50_000_000) int rayBudget,
        @Minor Listening listening,
        @In(value = Quantity.RATIO, from = 0, to = 1) Optional<Double> diffraction,
        @Minor @In(value = Quantity.NUMBER, from = 1, to = 10_000) int transmittedRays)
        implements Propagation {

    /** 10 initial rays, 10 reflections per hit, 0.05 dB/m, three orders, 200,000 ray segments. */
    @Defaults
    public static final LevelModel DEFAULT =
            new LevelModel(10, 10, 0.05, 3, 200_000, Listening.FAST, Optional.empty(), 1);

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public LevelModel {
        Limits.check(
                LevelModel.class,
                initialRays,
                reflectionsPerHit,
                attenuation,
                maxOrder,
                rayBudget,
                listening,
                diffraction,
                transmittedRays);
    }

    /** This model with other numbers of rays from the drone and from each surface. */
    public LevelModel withRays(int initial, int perHit) {
        return SettingsForm.with(this, Map.of("initialRays", initial, "reflectionsPerHit", perHit));
    }

    /** This model with another loss in the air, dB/m. */
    public LevelModel withAttenuation(double loss) {
        return SettingsForm.with(this, "attenuation", loss);
    }

    /** This model with another maximum order and another ray budget. */
    public LevelModel withLimits(int orders, int budget) {
        return SettingsForm.with(this, Map.of("maxOrder", orders, "rayBudget", budget));
    }

    /** This model with another criterion for ending a look. */
    public LevelModel withListening(Listening other) {
        return SettingsForm.with(this, "listening", other);
    }

    /** This model with another fraction of the energy that is scattered, 0 to 1. */
    public LevelModel withDiffraction(double fraction) {
        return SettingsForm.with(this, "diffraction", Optional.of(fraction));
    }

    /** This model with another number of rays from the far side of a wall. */
    public LevelModel withTransmittedRays(int count) {
        return SettingsForm.with(this, "transmittedRays", count);
    }

    @Override
    public SoundTracer tracer(Microphone microphone, World world) {
        return new LevelHearing(this, microphone, world);
    }

    @Override
    public String measures() {
        return "sound level";
    }

    @Override
    public String leavesOut() {
        return "The level model is empirical: its levels are fitted to measurements, are not sound pressure levels, and take no"
                + " account of wind or interference.";
    }

    @Override
    public Map<Condition, String> ignoredConditions() {
        String air = "'propagation: energy-model' takes the air into account";
        String spectrum = "'propagation: energy-model' takes the spectrum into account";
        return Map.of(
                Condition.AIR,
                air,
                Condition.WIND,
                air,
                Condition.NOISE_SOURCES,
                "set the source's soundLevel, which the level model needs",
                Condition.SOUND_POWER_LEVEL,
                "set the drone's soundLevel, which the level model uses",
                Condition.SOUND,
                spectrum,
                Condition.SPECTRUM,
                spectrum,
                Condition.DIRECTIVITY,
                "'propagation: energy-model' takes the directivity into account",
                Condition.TONES,
                "'propagation: energy-model' with 'criterion: narrow-band' uses tones");
    }
}
