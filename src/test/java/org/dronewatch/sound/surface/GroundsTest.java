package org.dronewatch.sound.surface;

import static org.assertj.core.api.Assertions.assertThat;

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
}
