package org.dronewatch.sound.surface;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;

/**
 * The acoustic properties of a surface, by octave band. A fraction {@code 1 - absorption} of the incident energy is
 * reflected; the rest is split between transmission, {@code 10^(-loss/10)}, and dissipation in the wall.
 *
 * @param name its name in the table
 * @param absorption fraction that is not reflected, 0 to 1, one for each of the eight bands
 * @param scattering fraction of the reflected energy that is scattered in all directions, 0 to 1, one for each band
 * @param transmissionLoss loss through the wall, 0 or more, one for each band, dB; none for an opaque wall
 * @param wall whether the wall is a single surface or has a front and a back
 * @param speed speed of sound inside the wall, m/s; empty if it is unknown or the wall is opaque
 * @param source source of the figures
 * @param angular absorption as a function of the angle of incidence; {@code absorption} is then its mean in a diffuse
 *     field. Empty if absorption is the same at all angles
 * @param ground impedance of the surface as ground, where direct and reflected sound interfere; empty to use the
 *     impedance under the same name in the table of grounds, if there is one
 */
public record SurfaceMaterial(
        String name,
        List<Double> absorption,
        List<Double> scattering,
        List<Double> transmissionLoss,
        Wall wall,
        OptionalDouble speed,
        String source,
        Optional<AngularAbsorption> angular,
        Optional<GroundImpedance> ground) {

    /** The model of a wall in a mesh. */
    public enum Wall {
        /** One surface is the whole wall, however thick the wall is. */
        SHEET,
        /** The wall has a front and a back; the loss is applied once, on entry. */
        SOLID
    }

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a fraction is outside 0 to 1, a loss is negative, or more energy would be
     *     reflected and transmitted than arrives
     */
    public SurfaceMaterial {
        Check.present("name", name);
        absorption = shares("absorption", name, absorption);
        scattering = shares("scattering", name, scattering);
        transmissionLoss = List.copyOf(transmissionLoss);
        Check.present("wall", wall);
        Check.present("speed", speed);
        Check.present("angular", angular);
        Check.present("ground", ground);
        if (!transmissionLoss.isEmpty()) {
            checkTransmission(name, absorption, transmissionLoss);
            List<Double> losses = transmissionLoss;
            angular.ifPresent(byAngle -> byAngle.table()
                    .forEach(row -> checkTransmission(name, row.absorption().toList(), losses)));
        }
    }

    /**
     * A material with the same absorption at all angles.
     *
     * @throws IllegalArgumentException if a fraction is outside 0 to 1, a loss is negative, or more energy would be
     *     reflected and transmitted than arrives
     */
    public SurfaceMaterial(
            String name,
            List<Double> absorption,
            List<Double> scattering,
            List<Double> transmissionLoss,
            Wall wall,
            OptionalDouble speed,
            String source) {
        this(name, absorption, scattering, transmissionLoss, wall, speed, source, Optional.empty(), Optional.empty());
    }

    private static List<Double> shares(String what, String name, List<Double> values) {
        if (values.size() != OctaveBands.COUNT) {
            throw new IllegalArgumentException(what + " of material '" + name + "' has " + values.size()
                    + " values but needs one for each of the " + OctaveBands.COUNT + " octave bands");
        }
        for (double value : values) {
            Check.between(what + " of material '" + name + "'", value, 0.0, 1.0, Quantity.NUMBER);
        }
        return List.copyOf(values);
    }

    private static void checkTransmission(String name, List<Double> absorption, List<Double> losses) {
        if (losses.size() != OctaveBands.COUNT) {
            throw new IllegalArgumentException(
                    "transmissionLoss of material '" + name + "' has " + losses.size() + " values but needs 8 or none");
        }
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            Check.notNegative("transmissionLoss of material '" + name + "'", losses.get(band), Quantity.LEVEL);
            double transmitted = Levels.toRatio(-losses.get(band));
            if (transmitted > absorption.get(band)) {
                throw new IllegalArgumentException("material '" + name + "' at " + OctaveBands.nominal(band)
                        + " Hz: reflects " + (1.0 - absorption.get(band)) + " and transmits " + transmitted
                        + ", together more than 1");
            }
        }
    }

    /** The impedance of this surface as ground; empty if it is not known. */
    public Optional<GroundImpedance> groundImpedance() {
        return ground.or(() -> Grounds.find(name));
    }

    /** The fraction that is reflected in a band in a diffuse field. */
    public double reflected(int band) {
        return 1.0 - absorption.get(band);
    }

    /**
     * The fraction that is reflected in a band.
     *
     * @param cosine cosine of the angle of incidence, from the normal, 0 to 1
     */
    public double reflected(int band, double cosine) {
        return angular.map(byAngle -> 1.0 - byAngle.at(band, cosine)).orElseGet(() -> reflected(band));
    }

    /** The fraction that is transmitted in a band, 0 for an opaque wall. */
    public double transmitted(int band) {
        return isOpaque() ? 0.0 : Levels.toRatio(-transmissionLoss.get(band));
    }

    /** Whether nothing is transmitted. */
    public boolean isOpaque() {
        return transmissionLoss.isEmpty();
    }

    /** This surface as a wall through which sound passes with a loss that is the same in all bands, dB. */
    public SurfaceMaterial withTransmissionLoss(double loss, Wall kind) {
        return SettingsForm.with(
                this, Map.of("transmissionLoss", Collections.nCopies(OctaveBands.COUNT, loss), "wall", kind));
    }

    /** An opaque surface with the same absorption and scattering in all bands. */
    public static SurfaceMaterial uniform(String name, double absorption, double scattering) {
        return new SurfaceMaterial(
                name,
                Collections.nCopies(OctaveBands.COUNT, absorption),
                Collections.nCopies(OctaveBands.COUNT, scattering),
                List.of(),
                Wall.SHEET,
                OptionalDouble.empty(),
                "given by the scene");
    }
}
