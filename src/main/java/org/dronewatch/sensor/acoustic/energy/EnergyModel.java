package org.dronewatch.sensor.acoustic.energy;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.sensor.Condition;
import org.dronewatch.sensor.acoustic.propagation.Diffraction;
import org.dronewatch.sensor.acoustic.propagation.Microphone;
import org.dronewatch.sensor.acoustic.propagation.Propagation;
import org.dronewatch.sensor.acoustic.propagation.SoundTracer;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.sound.surface.TurbulentCoherence;
import org.dronewatch.world.World;

/**
 * The energy model of sound propagation: levels in octave bands decrease due to spreading and to absorption in the air
 * and at surfaces. The straight path, specular reflections and the path around edges are computed exactly; scattered
 * sound is estimated by ray tracing, with its standard error.
 *
 * @param rays maximum number of rays that one look traces, 1 to 10,000,000
 * @param accuracy tracing stops once the statistical part of the standard error of the level is below this, 0 to 10
 *     dB; with 0, all rays are traced
 * @param roulette fraction of a ray's initial energy below which Russian roulette decides whether the ray survives,
 *     above 0 and below 1; in enclosed spaces, it is at most half the fraction that three surfaces leave on average
 * @param maxOrder maximum number of surfaces that a ray may hit before it is dropped, 0 to 10,000
 * @param imageSourceOrder order up to which purely specular paths are computed exactly, 1 to 50: all paths with one
 *     reflection, and those with several if rays from the microphone or from the drone find the surfaces
 * @param diffraction method for diffraction around edges
 * @param criterion level that is compared with the background
 * @param ground whether direct and ground-reflected sound interfere
 * @param turbulence if {@code ground} is {@code coherent}, the variance of the air's acoustic refractive index, 0 to
 *     0.001: 0 without turbulence, about 1e-8 in calm air, 1e-4 in very turbulent air
 * @param turbulenceScale if {@code ground} is {@code coherent}, the correlation length of the turbulence, 0.01 to 1000
 *     m
 * @param pressure conversion of intensity to sound pressure
 */
public record EnergyModel(
        @In(value = Quantity.NUMBER, from = 1, to = 10_000_000) int rays,
        @In(value = Quantity.LEVEL, from = 0, to = 10) double accuracy,
        @In(value = Quantity.NUMBER, above = 0, below = 1) double roulette,
        @In(value = Quantity.NUMBER, from = 0, to = 10_000) int maxOrder,
        @In(value = Quantity.NUMBER, from = 1, to = 50) @Formerly("mirrorOrder") int imageSourceOrder,
        Diffraction diffraction,
        Criterion criterion,
        Ground ground,
        @Minor @In(value = Quantity.NUMBER, from = 0, to = 1e-3) double turbulence,
        @Minor @In(value = Quantity.LENGTH, from = 0.01, to = 1000) double turbulenceScale,
        @Minor Pressure pressure)
        implements Propagation {

    /**
     * At most 8,000 rays, traced in batches until the standard error is below 0.2 dB; roulette threshold 0.5, maximum
     * order 1,000. For reverberation times, a roulette threshold of 0.001 is better.
     */
    @Defaults
    public static final EnergyModel DEFAULT = new EnergyModel(
            8_000,
            0.2,
            0.5,
            1000,
            20,
            Diffraction.MAEKAWA,
            Criterion.A_WEIGHTED,
            Ground.INCOHERENT,
            TurbulentCoherence.MODERATE.strength(),
            TurbulentCoherence.MODERATE.scale(),
            Pressure.REFERENCE);

    /** The criterion for the detection of a drone: the level that is compared with the background. */
    public enum Criterion {
        /** The A-weighted total level, compared with that of the background. */
        A_WEIGHTED,
        /** The level in each band, compared with that of the background; the best band counts. */
        BEST_BAND,
        /**
         * The level in a band around each of the drone's tones, as wide as the tone, compared with the level of the
         * background in the same band; the best of these bands counts. For a drone without tones, as
         * {@link #BEST_BAND}.
         */
        NARROW_BAND
    }

    /** A conversion of intensity to sound pressure. */
    public enum Pressure {
        /**
         * With the reference impedance of the standards, 400 Pa s/m, at which pressure level and intensity level are
         * equal.
         */
        REFERENCE,
        /** With the impedance of the scene's air: 0.1 dB more at 20 degrees Celsius, less on a mountain. */
        PHYSICAL
    }

    /** A method for adding direct and ground-reflected sound. */
    public enum Ground {
        /** The energies of direct and ground-reflected sound are added, as are those of all other paths. */
        INCOHERENT,
        /**
         * Direct and ground-reflected sound interfere, with the spherical-wave reflection coefficient of an impedance
         * ground and the coherence that remains after turbulence, averaged over each band.
         */
        COHERENT
    }

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public EnergyModel {
        Limits.check(
                EnergyModel.class,
                rays,
                accuracy,
                roulette,
                maxOrder,
                imageSourceOrder,
                diffraction,
                criterion,
                ground,
                turbulence,
                turbulenceScale,
                pressure);
    }

    /** This model with another maximum number of rays. */
    public EnergyModel withRays(int number) {
        return SettingsForm.with(this, "rays", number);
    }

    /** This model with another standard error at which tracing stops, dB. */
    public EnergyModel withAccuracy(double decibels) {
        return SettingsForm.with(this, "accuracy", decibels);
    }

    /** This model with another fraction of energy below which Russian roulette decides whether rays survive. */
    public EnergyModel withRoulette(double fraction) {
        return SettingsForm.with(this, "roulette", fraction);
    }

    /** This model with another maximum number of surfaces that a ray may hit. */
    public EnergyModel withMaxOrder(int orders) {
        return SettingsForm.with(this, "maxOrder", orders);
    }

    /** This model with exact specular reflections, by image sources, up to another order. */
    public EnergyModel withImageSourceOrder(int order) {
        return SettingsForm.with(this, "imageSourceOrder", order);
    }

    /** This model with another method for diffraction. */
    public EnergyModel withDiffraction(Diffraction kind) {
        return SettingsForm.with(this, "diffraction", kind);
    }

    /** This model with another method for adding ground-reflected sound. */
    public EnergyModel withGround(Ground kind) {
        return SettingsForm.with(this, "ground", kind);
    }

    /** This model with another variance of the air's acoustic refractive index, for coherent ground reflection. */
    public EnergyModel withTurbulence(double variance) {
        return SettingsForm.with(this, "turbulence", variance);
    }

    /** This model with another correlation length of the turbulence, m. */
    public EnergyModel withTurbulenceScale(double metres) {
        return SettingsForm.with(this, "turbulenceScale", metres);
    }

    /** This model with another conversion of intensity to sound pressure. */
    public EnergyModel withPressure(Pressure kind) {
        return SettingsForm.with(this, "pressure", kind);
    }

    /** This model with another criterion. */
    public EnergyModel withCriterion(Criterion kind) {
        return SettingsForm.with(this, "criterion", kind);
    }

    @Override
    public SoundTracer tracer(Microphone microphone, World world) {
        return new EnergyHearing(this, microphone, world);
    }

    @Override
    public String measures() {
        return switch (criterion) {
            case A_WEIGHTED -> "A-weighted sound level";
            case BEST_BAND -> "level above the background in the best band";
            case NARROW_BAND -> "level above the background in the band of the best tone";
        };
    }

    @Override
    public boolean hasBands() {
        return true;
    }

    @Override
    public String leavesOut() {
        return ground == Ground.COHERENT
                ? "The only interference in the energy model is that of direct and ground-reflected sound."
                : "The energy model does not account for interference: the energies of all paths add up.";
    }

    @Override
    public Map<Condition, String> ignoredConditions() {
        Map<Condition, String> ignored = new EnumMap<>(Condition.class);
        ignored.put(Condition.SOUND_LEVEL, "set the drone's soundPowerLevel, which the energy model uses");
        if (criterion != Criterion.NARROW_BAND) {
            ignored.put(Condition.TONES, "'criterion: narrow-band' uses tones");
        }
        return ignored;
    }

    @Override
    public List<String> advice() {
        boolean isCalmed = turbulence == DEFAULT.turbulence && turbulenceScale == DEFAULT.turbulenceScale;
        return ground == Ground.COHERENT || isCalmed
                ? List.of()
                : List.of("turbulence has no effect without 'ground: coherent'");
    }

    /** The speed of sound in the scene's air, m/s. */
    @Override
    public double signalSpeed(World world) {
        return world.atmosphere().speedOfSound();
    }
}
