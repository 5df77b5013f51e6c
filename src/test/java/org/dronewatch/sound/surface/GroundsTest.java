package org.dronewatch.sound.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dronewatch.sound.OctaveBands;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class GroundsTest {

    @ParameterizedTest
    @CsvSource({"grass_turf, 200", "forest_floor, 80", "asphalt, 20000", "perfect_mirror, Infinity"})
    void theTableHoldsOrdinaryGround(String name, double flowResistivity) {
        assertThat(Grounds.find(name)).hasValue(new GroundImpedance(flowResistivity));
    }

    @Test
    void everyGroundIsASurface() {
        assertThat(SurfaceMaterials.names()).containsAll(Grounds.names());
        assertThat(Grounds.find("brick_rough")).isEmpty();
    }

    /**
     * Where the absorption of ground was computed, it follows from the same flow resistivity as its interference: the
     * mean over angles of incidence (Paris 1928) for a locally reacting surface.
     */
    @Test
    void absorptionAndInterferenceAgree() {
        List<String> computed = Grounds.names().stream()
                .filter(name -> SurfaceMaterials.get(name).source().startsWith("computed: Delany-Bazley"))
                .toList();
        assertThat(computed).contains("grass_turf", "forest_floor", "asphalt").hasSizeGreaterThanOrEqualTo(8);
        for (String name : computed) {
            GroundImpedance ground = Grounds.find(name).orElseThrow();
            List<Double> stated = SurfaceMaterials.get(name).absorption();
            for (int band = 1; band < OctaveBands.COUNT - 1; band++) {
                assertThat(stated.get(band))
                        .as("%s at %d Hz", name, OctaveBands.nominal(band))
                        .isCloseTo(meanAbsorption(ground, OctaveBands.nominal(band)), within(0.011));
            }
        }
    }

    private static double meanAbsorption(GroundImpedance ground, double frequency) {
        Complex admittance = ground.admittance(frequency);
        int steps = 2000;
        double sum = 0;
        for (int i = 0; i < steps; i++) {
            double angle = (i + 0.5) * Math.PI / 2 / steps;
            double cosine = Math.cos(angle);
            double real = admittance.re();
            double absorbed = 4 * cosine * real / (Math.pow(cosine + real, 2) + Math.pow(admittance.im(), 2));
            sum += absorbed * Math.sin(2 * angle) * Math.PI / 2 / steps;
        }
        return sum;
    }
}
