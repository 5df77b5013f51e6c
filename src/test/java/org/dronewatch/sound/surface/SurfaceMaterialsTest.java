package org.dronewatch.sound.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.setting.InputException;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial.Wall;
import org.junit.jupiter.api.Test;

class SurfaceMaterialsTest {

    @Test
    void theTableHoldsTheOrdinarySurfacesEachWithItsSource() {
        assertThat(SurfaceMaterials.names())
                .hasSizeGreaterThanOrEqualTo(40)
                .contains("concrete_smooth", "brick_rough", "glass_window", "grass_turf", "solid", "window_double");
        for (String name : SurfaceMaterials.names()) {
            assertThat(SurfaceMaterials.get(name).source()).as(name).isNotBlank();
        }
    }

    @Test
    void theOuterBandsTakeTheirNeighbours() {
        SurfaceMaterial grass = SurfaceMaterials.get("grass_turf");

        assertThat(grass.absorption()).containsExactly(0.19, 0.19, 0.29, 0.41, 0.56, 0.71, 0.82, 0.82);
        assertThat(grass.isOpaque()).isTrue();
        assertThat(grass.transmitted(0)).isZero();
    }

    @Test
    void nothingIsReflectedAndTransmittedTwice() {
        for (String name : SurfaceMaterials.names()) {
            SurfaceMaterial material = SurfaceMaterials.get(name);
            for (int band = 0; band < OctaveBands.COUNT; band++) {
                assertThat(material.reflected(band) + material.transmitted(band))
                        .as("%s at %d Hz", name, OctaveBands.nominal(band))
                        .isBetween(0.0, 1.0 + 1e-12);
            }
        }
    }

    @Test
    void aMistypedNameIsAnsweredWithTheNearest() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> SurfaceMaterials.get("brick_ruogh"))
                .withMessageContaining("'brick_ruogh'")
                .withMessageContaining("brick_rough");
    }

    @Test
    void impossibleSurfacesAreRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> SurfaceMaterial.uniform("felt", 1.1, 0.1))
                .withMessageContaining("absorption of material 'felt' 1.1");
        assertThatIllegalArgumentException().isThrownBy(() -> SurfaceMaterial.uniform("felt", -0.1, 0.1));
        assertThatIllegalArgumentException().isThrownBy(() -> SurfaceMaterial.uniform("felt", 0.5, 2));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> SurfaceMaterial.uniform("net", 0.1, 0.1).withTransmissionLoss(3, Wall.SHEET))
                .withMessageContaining("more than 1");
        List<Double> seven = Collections.nCopies(7, 0.5);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new SurfaceMaterial(
                        "short", seven, seven, List.of(), Wall.SHEET, OptionalDouble.empty(), "none"))
                .withMessageContaining("7 values");
    }
}
