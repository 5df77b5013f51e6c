package org.dronewatch.sound.surface;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.sound.BandFractions;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.surface.SurfaceMaterial.Wall;

/**
 * An acoustic surface that a scene defines, in addition to, or in place of, those in the table. At most one of
 * {@code absorption} and {@code absorptionByAngle} is given; properties that are omitted are those of the table's
 * ordinary hard surface, {@code solid}.
 *
 * @param absorption fraction of the sound that is not reflected, 0 to 1, for all angles: eight octave bands, or one
 *     number
 * @param absorptionByAngle fraction of the sound that is not reflected, as a function of the angle from the normal: a
 *     table in order of increasing angle, linear between its angles, constant outside them
 * @param scattering fraction of the reflected energy that is scattered in all directions, 0 to 1: eight octave bands,
 *     or one number
 * @param transmissionLoss loss of sound that passes through the wall, 0 to 200 dB: eight octave bands, or one number;
 *     omit it for an opaque wall
 * @param wall whether the wall is a single surface (sheet) or has a front and a back (solid)
 * @param speed speed of sound inside a wall with a front and a back, for refraction in the level model, above 0 and at
 *     most 20,000 m/s; omit it if unknown
 * @param flowResistivity effective flow resistivity of this surface as ground, used if {@code ground} is
 *     {@code coherent} in the energy model, above 0 and at most 1,000,000 kPa s/m2: 200 for grass, 20,000 for asphalt;
 *     if it is omitted, the value of the surface of the same name in the table is used; if there is none, the surface
 *     reflects all unabsorbed sound in phase
 */
public record OwnSurface(
        Optional<BandFractions> absorption,
        Optional<List<AbsorptionAtAngle>> absorptionByAngle,
        BandFractions scattering,
        Optional<BandLevels> transmissionLoss,
        Wall wall,
        @In(value = Quantity.SPEED, above = 0, to = 20_000) Optional<Double> speed,
        @In(value = Quantity.NUMBER, above = 0, to = 1_000_000) Optional<Double> flowResistivity) {
    private static final BandFractions ORDINARY_ABSORPTION = BandFractions.flat(0.1);

    /**
     * The table's ordinary hard surface: an opaque sheet that absorbs a tenth of the sound and scatters a fifth of the
     * rest.
     */
    @Defaults
    public static final OwnSurface DEFAULT = new OwnSurface(
            Optional.empty(),
            Optional.empty(),
            BandFractions.flat(0.2),
            Optional.empty(),
            Wall.SHEET,
            Optional.empty(),
            Optional.empty());

    /**
     * Checks the limits and copies the list.
     *
     * @throws IllegalArgumentException if a value is out of range, absorption is given twice, angles do not increase,
     *     or more energy would be reflected and transmitted than arrives
     */
    public OwnSurface {
        Limits.check(
                OwnSurface.class,
                absorption,
                absorptionByAngle,
                scattering,
                transmissionLoss,
                wall,
                speed,
                flowResistivity);
        absorptionByAngle = absorptionByAngle.map(List::copyOf);
        if (absorption.isPresent() && absorptionByAngle.isPresent()) {
            throw new IllegalArgumentException("absorptionByAngle: absorption is given, too: omit one of the two");
        }
        material("own", absorption, absorptionByAngle, scattering, transmissionLoss, wall, speed, flowResistivity);
    }

    /** A surface that absorbs the same fraction, 0 to 1, in all bands and at all angles. */
    public static OwnSurface absorbing(double fraction) {
        return DEFAULT.withAbsorption(BandFractions.flat(fraction));
    }

    /** This surface with another absorption, the same at all angles. */
    public OwnSurface withAbsorption(BandFractions fractions) {
        return SettingsForm.with(
                this, Map.of("absorption", Optional.of(fractions), "absorptionByAngle", Optional.empty()));
    }

    /** This surface with another absorption, which depends on the angle of incidence. */
    public OwnSurface withAbsorptionByAngle(List<AbsorptionAtAngle> table) {
        return SettingsForm.with(this, Map.of("absorption", Optional.empty(), "absorptionByAngle", Optional.of(table)));
    }

    /** This surface with another scattered fraction of the reflected energy. */
    public OwnSurface withScattering(BandFractions fractions) {
        return SettingsForm.with(this, "scattering", fractions);
    }

    /** This surface as a wall through which sound passes, with a loss in dB. */
    public OwnSurface withTransmissionLoss(BandLevels loss, Wall kind) {
        return SettingsForm.with(this, Map.of("transmissionLoss", Optional.of(loss), "wall", kind));
    }

    /** This surface as ground with another effective flow resistivity, kPa s/m2. */
    public OwnSurface withFlowResistivity(double kilopascalSecondsPerSquareMetre) {
        return SettingsForm.with(this, "flowResistivity", Optional.of(kilopascalSecondsPerSquareMetre));
    }

    /** This surface as a material with a name. */
    public SurfaceMaterial material(String name) {
        return material(
                name, absorption, absorptionByAngle, scattering, transmissionLoss, wall, speed, flowResistivity);
    }

    private static SurfaceMaterial material(
            String name,
            Optional<BandFractions> absorption,
            Optional<List<AbsorptionAtAngle>> byAngle,
            BandFractions scattering,
            Optional<BandLevels> transmissionLoss,
            Wall wall,
            Optional<Double> speed,
            Optional<Double> flowResistivity) {
        Optional<AngularAbsorption> angular = byAngle.map(AngularAbsorption::new);
        return new SurfaceMaterial(
                name,
                angular.map(AngularAbsorption::atRandomIncidence)
                        .orElseGet(() -> absorption.orElse(ORDINARY_ABSORPTION).toList()),
                scattering.toList(),
                transmissionLoss
                        .map(loss -> Arrays.stream(loss.toArray()).boxed().toList())
                        .orElse(List.of()),
                wall,
                speed.map(OptionalDouble::of).orElseGet(OptionalDouble::empty),
                "given by the scene",
                angular,
                flowResistivity.map(GroundImpedance::new));
    }
}
