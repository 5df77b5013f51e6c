package org.dronewatch.sensor.acoustic.level;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.BandFractions;
import org.dronewatch.sound.surface.AbsorptionAtAngle;
import org.dronewatch.sound.surface.OwnSurface;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceMaterials;
import org.dronewatch.world.SurfaceSettings;
import org.dronewatch.world.World;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Branches at a level plane at z = 0 whose material is told by its name in the table. */
class ReflectionGeneratorTest {
    private static final double EXACT = 1e-12;
    private static final Position SENSOR = new Position(3, 0, 4);

    private record Branch(Vector3d direction, double z, double level, double energy, int order, int medium) {}

    private static World plane(String material) {
        return plane(material, SurfaceSettings.DEFAULT);
    }

    private static World plane(String material, SurfaceSettings surfaces) {
        TriangleMesh mesh = new TriangleMesh(
                new float[] {-9, -9, 0, 9, -9, 0, 0, 9, 0},
                new int[] {0, 1, 2},
                new int[1],
                new int[1],
                List.of(material));
        return new World(KDTree.of(mesh), BackgroundNoise.of(20), surfaces, Atmosphere.STANDARD);
    }

    private static AcousticRay towardsOrigin(double degrees, int medium) {
        AcousticRay ray = new AcousticRay();
        double angle = Math.toRadians(degrees);
        double side = medium == AcousticRay.AIR ? 1 : -1;
        ray.directionX = Math.sin(angle);
        ray.directionZ = -side * Math.cos(angle);
        ray.originX = -2 * ray.directionX;
        ray.originZ = -2 * ray.directionZ;
        ray.energy = 1.0;
        ray.medium = medium;
        return ray;
    }

    private static List<Branch> branches(String material, AcousticRay ray, int count) {
        return branches(material, ray, LevelModel.DEFAULT.withRays(1, count));
    }

    private static List<Branch> branches(String material, AcousticRay ray, LevelModel model) {
        World world = plane(material);
        List<Branch> branches = new ArrayList<>();
        new ReflectionGenerator(model, world, SENSOR)
                .acousticDistribution(
                        ray,
                        2.0,
                        0,
                        50.0,
                        new SplittableRandom(1),
                        b -> branches.add(new Branch(
                                new Vector3d(b.directionX, b.directionY, b.directionZ),
                                b.originZ,
                                b.level,
                                b.energy,
                                b.order,
                                b.medium)));
        return branches;
    }

    @Test
    void theFirstBranchIsSpecularTheSecondSeeksTheSensorTheRestFillTheHemisphere() {
        List<Branch> branches = branches("concrete_smooth", towardsOrigin(30, AcousticRay.AIR), 10_000);

        assertThat(branches).hasSize(10_000);
        assertThat(branches.get(0).direction().epsilonEquals(new Vector3d(0.5, 0, Math.sqrt(0.75)), EXACT))
                .isTrue();
        assertThat(branches.get(1).direction().epsilonEquals(new Vector3d(0.6, 0, 0.8), 1e-7))
                .isTrue();
        Vector3d mean = new Vector3d();
        for (Branch branch : branches.subList(2, branches.size())) {
            assertThat(branch.direction().z).isNotNegative();
            assertThat(branch.direction().length()).isCloseTo(1.0, within(EXACT));
            mean.scaleAdd(1.0 / (branches.size() - 2), branch.direction(), mean);
        }
        // Uniform over a hemisphere: the height is uniform from 0 to 1.
        assertThat(mean.epsilonEquals(new Vector3d(0, 0, 0.5), 0.02)).isTrue();
    }

    @Test
    void levelsAreUndividedAndEnergiesAreShared() {
        SurfaceMaterial concrete = SurfaceMaterials.get("concrete_smooth");
        List<Branch> branches = branches("concrete_smooth", towardsOrigin(30, AcousticRay.AIR), 20);

        double loss = -10 * Math.log10(concrete.reflected(4));
        assertThat(branches).allSatisfy(branch -> {
            assertThat(branch.level()).isCloseTo(50.0 - loss, within(EXACT));
            assertThat(branch.order()).isEqualTo(1);
            assertThat(branch.z()).isPositive();
        });
        assertThat(branches.stream().mapToDouble(Branch::energy).sum()).isCloseTo(concrete.reflected(4), within(EXACT));
    }

    /**
     * Into concrete at 3400 m/s sound bends away from the normal; beyond asin(343.2 / 3400) = 5.79 degrees all returns.
     */
    @Test
    void whatPassesIntoASolidFollowsSnell() {
        List<Branch> branches = branches("wall_concrete_200mm", towardsOrigin(5, AcousticRay.AIR), 1);

        assertThat(branches).hasSize(2);
        Branch inside = branches.get(1);
        double sin = Math.sin(Math.toRadians(5)) * 3400 / 343.2;
        assertThat(inside.direction().x).isCloseTo(sin, within(EXACT));
        assertThat(inside.direction().z).isCloseTo(-Math.sqrt(1 - sin * sin), within(EXACT));
        assertThat(inside.z()).isNegative();
        assertThat(inside.medium()).isZero();
        assertThat(inside.level()).isCloseTo(50.0 - 52.0, within(EXACT));
        assertThat(branches("wall_concrete_200mm", towardsOrigin(5.7, AcousticRay.AIR), 1))
                .hasSize(2);
        assertThat(branches("wall_concrete_200mm", towardsOrigin(5.9, AcousticRay.AIR), 1))
                .hasSize(1);
    }

    @Test
    void onTheWayOutTheDirectionIsRestoredAndNothingMoreIsLost() {
        double inside = Math.toDegrees(Math.asin(Math.sin(Math.toRadians(5)) * 3400 / 343.2));
        List<Branch> branches = branches("wall_concrete_200mm", towardsOrigin(inside, 0), 1);

        Branch outside = branches.get(1);
        assertThat(outside.direction().x).isCloseTo(Math.sin(Math.toRadians(5)), within(EXACT));
        assertThat(outside.direction().z).isPositive();
        assertThat(outside.medium()).isEqualTo(AcousticRay.AIR);
        assertThat(outside.level()).isEqualTo(50.0);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.0, 0.25, 1.0})
    void diffractionIsTheFractionOfTheEnergyThatIsScattered(double diffraction) {
        LevelModel model =
                LevelModel.DEFAULT.withRays(1, 20).withTransmittedRays(5).withDiffraction(diffraction);
        List<Branch> branches = branches("door_wood_solid", towardsOrigin(60, AcousticRay.AIR), model);

        SurfaceMaterial door = SurfaceMaterials.get("door_wood_solid");
        assertThat(branches).hasSize(25);
        List<Branch> reflected = branches.subList(0, 20);
        List<Branch> transmitted = branches.subList(20, 25);
        assertThat(reflected.get(0).energy()).isCloseTo((1 - diffraction) * door.reflected(4), within(EXACT));
        assertThat(transmitted.get(0).energy()).isCloseTo((1 - diffraction) * door.transmitted(4), within(EXACT));
        assertThat(energyOf(reflected)).isCloseTo(door.reflected(4), within(EXACT));
        assertThat(energyOf(transmitted)).isCloseTo(door.transmitted(4), within(EXACT));
        for (List<Branch> side : List.of(reflected, transmitted)) {
            assertThat(side).extracting(Branch::level).containsOnly(side.get(0).level());
            assertThat(side.subList(1, side.size()))
                    .extracting(Branch::energy)
                    .containsOnly(side.get(1).energy());
        }
    }

    private static double energyOf(List<Branch> branches) {
        return branches.stream().mapToDouble(Branch::energy).sum();
    }

    @Test
    void transmittedRaysFillTheHemisphereBehindTheWallAndTheFirstIsRefracted() {
        LevelModel model = LevelModel.DEFAULT.withRays(1, 1).withTransmittedRays(10_000);
        List<Branch> branches = branches("wall_concrete_200mm", towardsOrigin(5, AcousticRay.AIR), model);

        double sin = Math.sin(Math.toRadians(5)) * 3400 / 343.2;
        assertThat(branches.get(1).direction().x).isCloseTo(sin, within(EXACT));
        Vector3d mean = new Vector3d();
        List<Branch> scattered = branches.subList(2, branches.size());
        for (Branch branch : scattered) {
            assertThat(branch.direction().z).isNotPositive();
            assertThat(branch.z()).isNegative();
            assertThat(branch.medium()).isZero();
            mean.scaleAdd(1.0 / scattered.size(), branch.direction(), mean);
        }
        // Uniform over a hemisphere; the standard error of the mean height is 1 / sqrt(12 * 10,000).
        assertThat(scattered).hasSize(9_999);
        assertThat(mean.epsilonEquals(new Vector3d(0, 0, -0.5), 0.02)).isTrue();
        assertThat(branches("wall_concrete_200mm", towardsOrigin(5.9, AcousticRay.AIR), model))
                .as("total reflection")
                .hasSize(1);
    }

    @Test
    void aSheetKeepsTheDirection() {
        List<Branch> branches = branches("door_wood_solid", towardsOrigin(60, AcousticRay.AIR), 1);

        Branch behind = branches.get(1);
        AcousticRay ray = towardsOrigin(60, AcousticRay.AIR);
        assertThat(behind.direction().epsilonEquals(new Vector3d(ray.directionX, 0, ray.directionZ), EXACT))
                .isTrue();
        assertThat(behind.medium()).isEqualTo(AcousticRay.AIR);
        assertThat(behind.level()).isCloseTo(50.0 - 31.0, within(EXACT));
    }

    /** Half is absorbed upright and nine tenths at 60 degrees; at 30 degrees, 0.7: that is 5.23 dB. */
    @Test
    void theLossOfAReflectionFollowsTheAngle() {
        OwnSurface foam = OwnSurface.DEFAULT.withAbsorptionByAngle(List.of(
                new AbsorptionAtAngle(0.0, BandFractions.flat(0.5)),
                new AbsorptionAtAngle(Math.toRadians(60), BandFractions.flat(0.9))));
        World world = plane("foam", SurfaceSettings.DEFAULT.withOwn("foam", foam));
        List<Double> levels = new ArrayList<>();
        for (double degrees : new double[] {0, 30, 60, 80}) {
            new ReflectionGenerator(LevelModel.DEFAULT.withRays(1, 1), world, SENSOR)
                    .acousticDistribution(
                            towardsOrigin(degrees, AcousticRay.AIR),
                            2.0,
                            0,
                            50.0,
                            new SplittableRandom(1),
                            branch -> levels.add(branch.level));
        }
        double[] kept = {0.5, 0.3, 0.1, 0.1};
        for (int i = 0; i < kept.length; i++) {
            assertThat(levels.get(i)).isCloseTo(50 + 10 * Math.log10(kept[i]), within(1e-9));
        }
    }
}
