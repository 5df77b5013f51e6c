package org.dronewatch.report.sheet;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import org.dronewatch.buildings.land.LandClass;
import org.dronewatch.buildings.land.LandRaster;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.parallel.Workers;
import org.dronewatch.world.SurfaceSettings;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** The ground under plans, of a level square of 200 m with four fields of land cover. */
class ReliefShadeTest {
    private static final int PIXELS = 20;

    private static final World PLAIN = World.of(TriangleMesh.of(
            new float[] {-100, -100, 0, 100, -100, 0, 100, 100, 0, -100, 100, 0}, new int[] {0, 1, 2, 0, 2, 3}));

    /** The middle of each field: south-west, south-east, north-west, north-east. */
    private static Color[] colours(World world) {
        try (Workers workers = new Workers(2)) {
            int[] all = workers.call(() -> ReliefShade.of(world, 0, 0, 200, PIXELS));
            int low = PIXELS / 4;
            int high = 3 * PIXELS / 4;
            return new Color[] {
                new Color(all[high * PIXELS + low]),
                new Color(all[high * PIXELS + high]),
                new Color(all[low * PIXELS + low]),
                new Color(all[low * PIXELS + high])
            };
        }
    }

    private static int spread(Color colour) {
        int most = Math.max(colour.getRed(), Math.max(colour.getGreen(), colour.getBlue()));
        return most - Math.min(colour.getRed(), Math.min(colour.getGreen(), colour.getBlue()));
    }

    @Test
    void waterIsDarkerAndRoadsAreLighterThanTheGround() {
        byte[] codes = {
            (byte) LandClass.WATER.code(), (byte) LandClass.ROAD.code(),
            (byte) LandClass.NONE.code(), (byte) LandClass.GRASS.code()
        };
        Color[] colours = colours(PLAIN.withLandCover(new LandRaster(100.0, 2, codes), SurfaceSettings.DEFAULT));
        Color ground = colours[2];
        assertThat(colours[0].getRed()).isLessThan(ground.getRed() - 40);
        assertThat(colours[1].getRed()).isGreaterThan(ground.getRed() + 40);
        assertThat(colours[3]).isEqualTo(ground);
        for (Color colour : colours) {
            assertThat(spread(colour)).as("nearly grey").isLessThan(25);
        }
    }

    @Test
    void withoutLandCoverAllGroundIsAlike() {
        assertThat(colours(PLAIN)).containsOnly(colours(PLAIN)[0]);
    }
}
