package org.dronewatch.sensor.optics;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.SplittableRandom;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.silhouette.SilhouetteMask;
import org.dronewatch.drone.silhouette.SilhouetteTable;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.junit.jupiter.api.Test;

/** The texels that a bundle's rays meet, kept from one mask to the next, against those of each ray alone. */
class BundleTexelsTest {
    private static final int LOOKS = 300;

    @Test
    void allRaysHaveTheKindOfTheirTexel() {
        long seed = System.nanoTime();
        System.out.println("BundleTexelsTest: seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        Drone quadrotor = DroneSettings.of(ModelSettings.packaged("quadrotor.obj"), Hover.at(new Position(0, 0, 0)))
                .create("drone", Path.of(""));
        SilhouetteMask[] masks = new SilhouetteMask[5];
        for (int i = 0; i < masks.length; i++) {
            masks[i] = mask(quadrotor.silhouettes(), random);
        }
        // Two assessors, as of two threads, and drones of two sizes share the masks.
        SilhouetteArea.BundleTexels[] texels = {new SilhouetteArea.BundleTexels(), new SilhouetteArea.BundleTexels()};
        double[] halves = {61.3, 47.9};
        byte[] kinds = new byte[RayBundle.RAYS];
        int covered = 0;
        for (int i = 0; i < LOOKS; i++) {
            SilhouetteMask mask = masks[random.nextInt(masks.length)];
            double fromAfar = halves[random.nextInt(halves.length)];
            // From closer than masks are used for, so that rays leave them, to far away.
            double half = fromAfar * (1.0 + Math.exp(-15.0 * random.nextDouble()) * 0.1);
            texels[random.nextInt(texels.length)].look(mask, half, fromAfar, kinds);
            for (int ray = 0; ray < RayBundle.RAYS; ray++) {
                int column = (int) Math.floor(0.5 * SilhouetteMask.TEXELS + half * RayBundle.across(ray));
                int row = (int) Math.floor(0.5 * SilhouetteMask.TEXELS + half * RayBundle.upwards(ray));
                boolean isOnMask = Math.min(column, row) >= 0 && Math.max(column, row) < SilhouetteMask.TEXELS;
                byte kind = isOnMask ? mask.kind(row * SilhouetteMask.TEXELS + column) : SilhouetteMask.OUTSIDE;
                assertThat(kinds[ray])
                        .as("seed %d, look %d, half %s, ray %d", seed, i, half, ray)
                        .isEqualTo(kind);
                covered += kind == SilhouetteMask.OUTSIDE ? 0 : 1;
            }
        }
        assertThat(covered).as("rays that may meet the drone").isGreaterThan(LOOKS * RayBundle.RAYS / 20);
    }

    private static SilhouetteMask mask(SilhouetteTable table, SplittableRandom random) {
        double azimuth = 6.0 * random.nextDouble();
        double elevation = random.nextDouble() - 0.5;
        SilhouetteMask mask = null;
        while (mask == null) {
            mask = table.mask(azimuth, elevation, 100);
        }
        return mask;
    }
}
