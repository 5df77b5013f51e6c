package org.dronewatch.sound.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.sound.BandFractions;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial.Wall;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Angle-dependent absorption against the closed formulas for locally reacting walls. */
class AngularAbsorptionTest {
    private static AbsorptionAtAngle at(double degrees, double absorption) {
        return new AbsorptionAtAngle(Math.toRadians(degrees), BandFractions.flat(absorption));
    }

    /**
     * A locally reacting wall of real impedance {@code z} over that of air absorbs {@code 4 z cos t / (1 + z cos t)^2}
     * (Kuttruff, Room Acoustics, section 2.3); as a table by degrees.
     */
    private static List<AbsorptionAtAngle> locallyReacting(double z) {
        List<AbsorptionAtAngle> table = new ArrayList<>();
        for (int degrees = 0; degrees <= 90; degrees++) {
            double cosine = Math.max(0.0, Math.cos(Math.toRadians(degrees)));
            table.add(at(degrees, Math.min(1.0, 4 * z * cosine / Math.pow(1 + z * cosine, 2))));
        }
        return table;
    }

    /** Kuttruff, Room Acoustics, section 2.5: {@code 8/z (1 + 1/(1+z) - 2/z ln(1+z))} for a real impedance. */
    @ParameterizedTest
    @ValueSource(doubles = {1.0, 1.567, 4.0, 20.0})
    void soundFromAllSidesIsAbsorbedAsParisSays(double z) {
        double closed = 8 / z * (1 + 1 / (1 + z) - 2 / z * Math.log(1 + z));

        assertThat(new AngularAbsorption(locallyReacting(z)).atRandomIncidence())
                .hasSize(OctaveBands.COUNT)
                .allSatisfy(mean -> assertThat(mean).isCloseTo(closed, within(2e-4)));
    }

    @Test
    void itIsLinearBetweenAnglesAndConstantOutside() {
        AngularAbsorption table = new AngularAbsorption(List.of(at(20, 0.2), at(60, 0.6)));

        for (double[] expected : new double[][] {{0, 0.2}, {20, 0.2}, {30, 0.3}, {45, 0.45}, {60, 0.6}, {90, 0.6}}) {
            assertThat(table.at(3, Math.cos(Math.toRadians(expected[0])))).isCloseTo(expected[1], within(1e-12));
        }
        double sum = 0.0;
        int steps = 100_000;
        for (int i = 0; i < steps; i++) {
            double angle = Math.PI / 2 * (i + 0.5) / steps;
            sum += table.at(3, Math.cos(angle)) * Math.sin(2 * angle) * Math.PI / 2 / steps;
        }
        assertThat(table.atRandomIncidence().get(3)).isCloseTo(sum, within(1e-8));
    }

    @Test
    void aSurfaceOfOnesOwnIsAMaterial() {
        SurfaceMaterial plain = OwnSurface.absorbing(0.3).material("panel");
        assertThat(plain.name()).isEqualTo("panel");
        assertThat(plain.absorption()).containsOnly(0.3);
        assertThat(plain.isOpaque()).isTrue();
        assertThat(plain.reflected(2, 0.1)).isEqualTo(0.7);

        SurfaceMaterial ordinary = OwnSurface.DEFAULT.material("solid");
        assertThat(ordinary.absorption())
                .isEqualTo(SurfaceMaterials.get("solid").absorption());
        assertThat(ordinary.scattering())
                .isEqualTo(SurfaceMaterials.get("solid").scattering());

        SurfaceMaterial angular = OwnSurface.DEFAULT
                .withAbsorptionByAngle(List.of(at(0, 0.9), at(90, 0.1)))
                .withTransmissionLoss(BandLevels.flat(20), Wall.SOLID)
                .material("foam");
        assertThat(angular.reflected(0, 1.0)).isCloseTo(0.1, within(1e-12));
        assertThat(angular.reflected(0, 0.0)).isCloseTo(0.9, within(1e-12));
        assertThat(angular.absorption().get(0)).isCloseTo(0.5, within(1e-12));
        assertThat(angular.transmitted(0)).isCloseTo(0.01, within(1e-12));
    }

    @Test
    void whatCannotBeIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> OwnSurface.DEFAULT.withAbsorptionByAngle(List.of(at(30, 0.2), at(30, 0.3))))
                .withMessage("angle 30.0 deg must be above the one before it, 30.0 deg");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> OwnSurface.DEFAULT
                        .withAbsorptionByAngle(List.of(at(0, 0.5), at(90, 0.01)))
                        .withTransmissionLoss(BandLevels.flat(10), Wall.SHEET))
                .withMessageContaining("reflects 0.99 and transmits 0.1, together more than 1");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> OwnSurface.absorbing(1.5))
                .withMessage("hz63 1.5 must be 0 to 1");
    }
}
