package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.propagation.Diffraction;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceMaterial.Wall;
import org.dronewatch.world.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Solids that overlap, as walls do where models were merged: each takes its loss once. */
class OverlappingSolidsTest {
    private static final SurfaceMaterial CONCRETE =
            SurfaceMaterial.uniform("concrete", 0.1, 0.2).withTransmissionLoss(12, Wall.SOLID);
    private static final SurfaceMaterial BRICK =
            SurfaceMaterial.uniform("brick", 0.2, 0.2).withTransmissionLoss(8, Wall.SOLID);
    private static final SurfaceMaterial GROUND = SurfaceMaterial.uniform("ground", 0.1, 0.5);
    private static final EnergyModel MODEL = EnergyModel.DEFAULT
            .withDiffraction(Diffraction.OFF)
            .withAccuracy(0.05)
            .withRays(50_000);
    private static final Position BEFORE = new Position(-5, 0.3, 2);
    private static final Position BEHIND = new Position(5, 0.1, 1.5);

    /** The brick begins beyond the concrete, touches it, overlaps with it or lies within it. */
    @ParameterizedTest
    @ValueSource(doubles = {0.21, 0.2, 0.19, 0.1, 0.05})
    void eachTakesItsLossOnce(double brick) {
        for (boolean back : new boolean[] {false, true}) {
            Position source = back ? BEHIND : BEFORE;
            Position sensor = back ? BEFORE : BEHIND;
            EnergyReading reading = Sites.read(MODEL, walls(brick), Sites.broadband(source), sensor, 1);
            EnergyReading open = Sites.read(MODEL, Sites.open(), Sites.broadband(source), sensor, 1);
            for (int band = 0; band < OctaveBands.COUNT; band++) {
                assertThat(Levels.ofRatio(reading.direct().get(band)))
                        .isCloseTo(Levels.ofRatio(open.direct().get(band)) - 20, within(1e-9));
            }
        }
    }

    /** Rays count the same losses: by how much the solids overlap, or whether they only touch, makes no difference. */
    @ParameterizedTest
    @CsvSource({"0.19, false", "0.2, false", "0.2, true"})
    void scatteredSoundDoesNotDependOnTheOverlap(double brick, boolean isExchanged) {
        // Some paths are found by few rays: a reading must not stop before it has them.
        EnergyModel model = MODEL.withAccuracy(0.0).withRays(100_000);
        Position source = isExchanged ? BEHIND : BEFORE;
        Position sensor = isExchanged ? BEFORE : BEHIND;
        EnergyReading slight = Sites.read(model, walls(brick), Sites.broadband(source), sensor, 2);
        EnergyReading deep = Sites.read(model, walls(0.1), Sites.broadband(BEFORE), BEHIND, 3);
        assertThat(slight.aWeightedLevel())
                .isCloseTo(
                        deep.aWeightedLevel(),
                        within(4 * Math.hypot(slight.standardError(), deep.standardError()) + 0.01));
        assertThat(slight.isConverged() && deep.isConverged()).isTrue();
    }

    private static World walls(double brick) {
        return Sites.world(
                List.of(
                        Sites.square(50, 0),
                        Sites.box(0, -50, -1, 0.2, 50, 50),
                        Sites.box(brick, -50, -1, brick + 0.11, 50, 50)),
                List.of(GROUND, CONCRETE, BRICK));
    }
}
