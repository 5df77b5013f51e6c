package org.dronewatch.terrain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashSet;
import java.util.Set;
import org.dronewatch.sound.surface.Grounds;
import org.dronewatch.sound.surface.SurfaceMaterials;
import org.junit.jupiter.api.Test;

/** What ground of a material looks like. */
class GroundColoursTest {
    private static int of(String material) {
        return TerrainSettings.of("ground.asc").withMaterial(material).colour();
    }

    @Test
    void waterIsBlueAsphaltGreyAndGrassGreen() {
        int water = of("water_surface");
        assertThat(water & 255).isGreaterThan(water >> 8 & 255);
        assertThat(water >> 8 & 255).isGreaterThan(water >> 16);
        int asphalt = of("asphalt");
        assertThat(Math.abs((asphalt >> 16) - (asphalt & 255))).isLessThan(8);
        int grass = of("grass_turf");
        assertThat(grass >> 8 & 255).isGreaterThan(grass >> 16).isGreaterThan(grass & 255);
        assertThat(of("snow_fresh_100mm") >> 16).isGreaterThan(230);
    }

    @Test
    void whatIsNotKnownIsAMeadow() {
        assertThat(TerrainSettings.DEFAULT.colour()).isEqualTo(TerrainSettings.COLOUR);
        assertThat(of("the-lawn-of-the-palace")).isEqualTo(TerrainSettings.COLOUR);
        assertThat(of("water_surface:harbour")).isEqualTo(of("water_surface"));
    }

    /** Each ground with an impedance has a colour that no other has, and is one of the table of surfaces. */
    @Test
    void everyGroundOfTheTableHasItsColour() {
        Set<String> grounds = new LinkedHashSet<>(Grounds.names());
        grounds.remove("perfect_mirror");
        assertThat(SurfaceMaterials.names()).containsAll(grounds);
        assertThat(grounds.stream().map(GroundColoursTest::of)).doesNotHaveDuplicates();
    }
}
