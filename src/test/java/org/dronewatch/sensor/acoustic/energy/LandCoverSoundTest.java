package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dronewatch.buildings.land.LandClass;
import org.dronewatch.buildings.land.LandRaster;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.sensor.acoustic.energy.EnergyModel.Ground;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.SiteModel;
import org.dronewatch.world.SurfaceSettings;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Ground that is covered sounds like ground that is made of what covers it; a house on it does not change. */
class LandCoverSoundTest {
    private static final double HALF = 200.0;
    private static final Position SOURCE = new Position(-40, 3, 6);
    private static final Position SENSOR = new Position(45, -4, 1.5);
    private static final TriangleMesh WEST = Sites.wall(2, 0.0, -HALF, 0.0, -HALF, HALF);
    private static final TriangleMesh EAST = Sites.wall(2, 0.0, 0.0, HALF, -HALF, HALF);
    private static final TriangleMesh HOUSE = Sites.box(20, 10, -1, 30, 20, 8);

    private static TriangleMesh of(String material, TriangleMesh mesh) {
        return new TriangleMesh(
                mesh.vertices(),
                mesh.corners(),
                new int[mesh.triangleCount()],
                new int[mesh.triangleCount()],
                List.of(material));
    }

    private static World world(String west, String east) {
        return world(of(west, WEST), of(east, EAST));
    }

    private static World world(TriangleMesh... ground) {
        TriangleMesh all = World.merge(List.of(ground));
        TriangleMesh site = World.merge(List.of(all, of("brick_rendered", HOUSE)));
        Map<Integer, SiteModel> models = Map.of(
                0,
                new SiteModel("ground", ModelRole.TERRAIN),
                all.triangleCount(),
                new SiteModel("house", ModelRole.BUILDING));
        return new World(KDTree.of(site), BackgroundNoise.of(20), SurfaceSettings.DEFAULT, Atmosphere.STANDARD)
                .withModels(new TreeMap<>(models));
    }

    /** A raster of four cells. */
    private static LandRaster halves(LandClass west, LandClass east) {
        byte[] codes = {(byte) west.code(), (byte) east.code(), (byte) west.code(), (byte) east.code()};
        return new LandRaster(HALF, 2, codes);
    }

    private static World covered(World plain, LandClass west, LandClass east) {
        return plain.withLandCover(halves(west, east), SurfaceSettings.DEFAULT);
    }

    private static double[] levels(World world, Ground ground) {
        EnergyModel model = EnergyModel.DEFAULT.withRays(2000).withGround(ground);
        EnergyReading reading = Sites.read(model, world, Sites.broadband(SOURCE), SENSOR, 7);
        double[] levels = new double[OctaveBands.COUNT];
        Arrays.setAll(levels, reading::level);
        return levels;
    }

    /** The same triangles, so that the same rays meet them: the same to the last bits. */
    @ParameterizedTest
    @EnumSource(Ground.class)
    void itSoundsLikeGroundOfThatMaterial(Ground ground) {
        World meadow = world("pasture_uncompacted", "pasture_uncompacted");
        double[] overMeadow = levels(meadow, ground);
        double[] overLake = levels(world("water_surface", "water_surface"), ground);
        assertThat(levels(covered(meadow, LandClass.WATER, LandClass.WATER), ground))
                .containsExactly(overLake, within(1e-9));
        assertThat(levels(covered(meadow, LandClass.NONE, LandClass.NONE), ground))
                .containsExactly(overMeadow);
        assertThat(Math.abs(overLake[4] - overMeadow[4])).isGreaterThan(0.5);

        double[] overShore = levels(world("water_surface", "grass_turf"), ground);
        assertThat(levels(covered(meadow, LandClass.WATER, LandClass.GRASS), ground))
                .containsExactly(overShore, within(1e-9));
    }

    /** A border that runs through triangles, instead of between them. */
    @ParameterizedTest
    @EnumSource(Ground.class)
    void theBorderMayRunThroughTriangles(Ground ground) {
        World square = world(of("pasture_uncompacted", Sites.square(HALF, 0.0)));
        double[] cut = levels(world("water_surface", "grass_turf"), ground);
        assertThat(levels(covered(square, LandClass.WATER, LandClass.GRASS), ground))
                .containsExactly(cut, within(0.05));
    }

    /** Where the ground itself mirrors nothing, a lake on it does. */
    @Test
    void aLakeMirrorsOnGroundThatDoesNot() {
        World hole = world("perfect_absorber", "perfect_absorber");
        double[] overLake = levels(world("water_surface", "water_surface"), Ground.INCOHERENT);
        assertThat(levels(covered(hole, LandClass.WATER, LandClass.WATER), Ground.INCOHERENT))
                .containsExactly(overLake, within(1e-9));
    }
}
