package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.imagesource.ImageSources;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.PathCurvature;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** When rays tell a level, how accurately, and what is allowed for those that were not drawn. */
class ConvergenceTest {
    private static final int BAND = 4;
    private static final double ACCURACY = 0.2;
    private static final double FLOOR = 0.005;
    private static final double ROULETTE = 0.1;
    private static final double RADIUS = 0.5;

    /** So far apart that hardly anything is allowed for rays that were not drawn, m. */
    private static final double FAR = 1e9;

    private final EnergyTally tally = new EnergyTally(new Air(Atmosphere.STANDARD));
    private final MissedRays missed = new MissedRays(
            0.5, new BandSurfaces(List.of(SurfaceMaterial.uniform("half", 0.2, 0.5), wall("full", 1.0))));
    private final Convergence convergence = new Convergence(tally, missed);

    private static SurfaceMaterial wall(String name, double scattering) {
        return SurfaceMaterial.uniform(name, 0.1, scattering);
    }

    /** Rays whose mean contribution is one, of which some contribute alike and the others nothing. */
    private void trace(int rays, int contributing) {
        trace(rays, contributing, 1.0);
    }

    private void trace(int rays, int contributing, double mean) {
        tally.clear();
        double[] inBand = new double[OctaveBands.COUNT];
        AcousticRay ray = new AcousticRay();
        for (int i = 0; i < rays; i++) {
            inBand[BAND] = mean * rays / contributing;
            if (i < contributing) {
                tally.add(ray, inBand, 0);
            }
            tally.endRay();
        }
    }

    private void between(double distance, Set<Integer> scatterers) {
        between(distance, scatterers, true);
    }

    private void between(double distance, Set<Integer> scatterers, boolean isOpen) {
        ImageSources none = ImageSources.NONE;
        SoundSource source = Sites.sound(new Position(distance, 0, 0), BAND);
        missed.between(new Ends(
                source,
                new Position(0, 0, 0),
                false,
                none,
                none,
                none,
                none,
                none,
                0,
                PathCurvature.NONE,
                isOpen,
                false,
                ROULETTE,
                scatterers));
    }

    /**
     * In an enclosed space, paths of specular reflections that no image source leads to are heard only in rays that
     * happen to pass: a look does not end before one of them is weak, and allows for one, even if nothing scatters.
     */
    @Test
    void inAnEnclosedSpaceARayThatPassesIsWeak() {
        between(FAR, Set.of(), false);
        double passing = ROULETTE / (Math.PI * RADIUS * RADIUS);
        double heard = passing / (2000.5 * 0.01);
        trace(2000, 2000, heard);
        assertThat(convergence.isAccurate(BAND, heard, ACCURACY)).isFalse();
        trace(2001, 2001, heard);
        assertThat(convergence.isAccurate(BAND, heard, ACCURACY)).isTrue();
        assertThat(convergence.error(BAND, heard)).isGreaterThan(0.005 / Math.sqrt(3) * 10 / Math.log(10));
        between(FAR, Set.of(), true);
        assertThat(convergence.error(BAND, heard)).isLessThan(0.005);
    }

    /** One over the root of the number of contributions, as of a binomial of low probability, and half of one more. */
    @Test
    void whereRaysContributeMuchTheErrorIsTheirScatter() {
        between(FAR, Set.of());
        trace(2000, 100);
        double drawn = Math.sqrt(100 * (1 - 100 / 2000.0) + 0.5) / 100;
        assertThat(convergence.error(BAND, 1.0)).isCloseTo(Levels.ofRatio(1 + drawn), within(1e-9));
        assertThat(convergence.error(BAND, 4.0)).isCloseTo(Levels.ofRatio(1 + drawn / 4), within(1e-9));
    }

    /** A ray that was missed, up to 1 % of what is heard, adds to the scatter; a stronger one is the least error. */
    @Test
    void whereRaysContributeMuchOneThatWasMissedMayBeNearlyAThirdOfIt() {
        between(1, Set.of(1));
        double all = 3.0 * missed.contribution(BAND) / 3000;
        trace(3000, 300, all);
        double drawn = Math.sqrt(300 * (1 - 300 / 3000.0) + 0.5) / 300;
        assertThat(convergence.error(BAND, all))
                .as("a third of all: 70 % of it")
                .isCloseTo(Levels.ofRatio(1 + 0.7 / 3 / Math.sqrt(3)), within(1e-9));
        assertThat(convergence.error(BAND, 5 * all))
                .as("also where paths without rays are most of it")
                .isCloseTo(Levels.ofRatio(1 + 0.7 / 15 / Math.sqrt(3)), within(1e-9));
        trace(3000, 300, all / 2);
        assertThat(convergence.error(BAND, all))
                .as("two thirds of what rays contribute: 30 % of that")
                .isCloseTo(Levels.ofRatio(1 + 0.15 / Math.sqrt(3)), within(1e-9));
        trace(3000, 300, 40 * all);
        assertThat(convergence.error(BAND, 40 * all))
                .as("one part in 120")
                .isCloseTo(Levels.ofRatio(1 + Math.hypot(drawn, 1 / 120.0 / Math.sqrt(3))), within(1e-9));
        trace(3000, 300, 10 * all);
        assertThat(convergence.error(BAND, 10 * all))
                .as("one part in 30: one in a hundred is allowed for")
                .isCloseTo(Levels.ofRatio(1 + Math.hypot(drawn, 0.01 / Math.sqrt(3))), within(1e-9));
    }

    @Test
    void twentyContributionsSufficeWhereRaysContributeMuch() {
        between(FAR, Set.of());
        trace(1000, 21);
        assertThat(convergence.isAccurate(BAND, 6.0, ACCURACY)).isTrue();
        assertThat(convergence.isAccurate(BAND, 1.0, ACCURACY))
                .as("error of 0.9 dB")
                .isFalse();
        trace(1000, 19);
        assertThat(convergence.isAccurate(BAND, 6.0, ACCURACY)).isFalse();
        assertThat(convergence.isReached(BAND, 1.0)).isFalse();
        assertThat(convergence.isReached(BAND, 6.0))
                .as("one ray is one part in 114")
                .isTrue();
    }

    @Test
    void whereRaysContributeLittleItTakesSeveralThousandOrManyContributions() {
        between(FAR, Set.of());
        trace(2999, 60);
        assertThat(convergence.isAccurate(BAND, 20.0, ACCURACY)).isFalse();
        trace(3000, 60);
        assertThat(convergence.isAccurate(BAND, 20.0, ACCURACY)).isTrue();
        trace(3000, 39);
        assertThat(convergence.isAccurate(BAND, 20.0, ACCURACY)).isFalse();
        trace(1000, 200);
        assertThat(convergence.isAccurate(BAND, 20.0, ACCURACY)).isTrue();
        assertThat(convergence.isAccurate(BAND, 20.1, ACCURACY))
                .as("less than a twentieth: many small contributions may hide a few strong ones")
                .isFalse();
        trace(1000, 400);
        assertThat(convergence.isAccurate(BAND, 20.1, ACCURACY)).isTrue();
    }

    @Test
    void whereRaysContributeHardlyAnythingTheFirstOnesSuffice() {
        between(1, Set.of(1));
        trace(1000, 3);
        assertThat(convergence.isAccurate(BAND, 101.0, ACCURACY)).isTrue();
        assertThat(convergence.isReached(BAND, 101.0)).isTrue();
        assertThat(convergence.isAccurate(BAND, 99.0, ACCURACY)).isFalse();
        assertThat(convergence.isAccurate(0, 100.0, ACCURACY))
                .as("nothing in this band so far")
                .isFalse();
        trace(3000, 3);
        assertThat(convergence.isAccurate(0, 100.0, ACCURACY)).isTrue();
    }

    @Test
    void theAllowanceIsPartOfTheErrorWhereFewRaysContributeLittle() {
        trace(1000, 39, 1e-9);
        between(1, Set.of(1));
        double ofOneRay = missed.contribution(BAND) / 1000;
        assertThat(convergence.error(BAND, ofOneRay / 0.01))
                .as("such a ray is one part in a hundred")
                .isCloseTo(Math.hypot(Levels.ofRatio(1 + 0.01 / Math.sqrt(3)), FLOOR), within(1e-6));
        assertThat(convergence.error(BAND, ofOneRay / 0.5))
                .as("no more than 2 % is allowed for")
                .isCloseTo(Math.hypot(Levels.ofRatio(1 + 0.02 / Math.sqrt(3)), FLOOR), within(1e-6))
                .isLessThan(ReadingSpread.ALLOWANCE);
        assertThat(convergence.error(BAND, ofOneRay / 0.009))
                .as("also if it is weak: few contribute")
                .isCloseTo(Math.hypot(Levels.ofRatio(1 + 0.009 / Math.sqrt(3)), FLOOR), within(1e-6));
        between(1, Set.of());
        assertThat(convergence.error(BAND, ofOneRay / 0.5))
                .as("where nothing scatters, nothing can be missed")
                .isCloseTo(0.0, within(1e-6));
    }

    /** Rays contribute little if the strong ones were missed: only for a weak one it matters what they contribute. */
    @Test
    void theAllowanceIsPartOfTheErrorWhereManyRaysContributeLittle() {
        between(1, Set.of(1));
        trace(1000, 50, 1e-3);
        double drawn = Math.sqrt(50 * (1 - 50 / 1000.0) + 0.5) / 50;
        double systematic = 0.046 * Math.sqrt(3);
        double ofRays = Math.hypot(drawn, systematic) * 1e-3;
        double one = missed.contribution(BAND) / 1000;
        double heard = one / 0.03;
        assertThat(convergence.error(BAND, heard))
                .as("one part in 33: 2 % are allowed for")
                .isCloseTo(Levels.ofRatio(1 + Math.hypot(ofRays / heard, 0.02 / Math.sqrt(3))), within(1e-9));
        heard = one / 0.011;
        assertThat(convergence.error(BAND, heard))
                .as("one part in 91: all of it")
                .isCloseTo(Levels.ofRatio(1 + Math.hypot(ofRays / heard, 0.011 / Math.sqrt(3))), within(1e-9));
        heard = one / 0.009;
        assertThat(convergence.error(BAND, heard))
                .as("one part in 111: 10 % of what rays contribute")
                .isCloseTo(Levels.ofRatio(1 + Math.hypot(ofRays, 0.1e-3 / Math.sqrt(3)) / heard), within(1e-9));
    }

    /** Whether the rays that were drawn contribute little, or hardly anything, or nothing. */
    @Test
    void aRayThatMayBeATenthOfWhatIsHeardIsWaitedFor() {
        between(1, Set.of(1));
        double heard = missed.contribution(BAND) / 4000 / 0.1;
        assertThat(convergence.mostNeeded(BAND, heard)).isCloseTo(4000, within(1e-6));
        for (double fraction : new double[] {0.14, 0.009}) {
            trace(3990, 60, fraction * heard);
            assertThat(convergence.isAccurate(BAND, heard, ACCURACY)).isFalse();
            trace(4010, 60, fraction * heard);
            assertThat(convergence.isAccurate(BAND, heard, ACCURACY)).isTrue();
        }
        trace(3990, 0);
        assertThat(convergence.isAccurate(BAND, heard, ACCURACY)).isFalse();
        trace(4010, 0);
        assertThat(convergence.isAccurate(BAND, heard, ACCURACY)).isTrue();
        trace(1000, 400, 0.04 * heard);
        assertThat(convergence.isAccurate(BAND, heard, ACCURACY))
                .as("many small contributions, from all around")
                .isTrue();
    }

    /** As well as 3,000 rays are taken to tell what they contribute, and four times as many. */
    @Test
    void raysTellWhatTheyContributeToAFewPerCent() {
        between(1, Set.of());
        trace(3000, 3000, 0.005);
        double ofOneInAThousand = Math.sqrt(0.5) / 3000;
        assertThat(convergence.error(BAND, 1.0))
                .isCloseTo(Levels.ofRatio(1 + 0.005 * Math.hypot(0.046, ofOneInAThousand)), within(1e-9));
        trace(12_000, 12_000, 0.005);
        assertThat(convergence.error(BAND, 1.0)).isCloseTo(Levels.ofRatio(1 + 0.005 * 0.023), within(1e-6));
        trace(3000, 3000, 0.1);
        double most = 0.0035 * Math.sqrt(150 / 3000.0);
        assertThat(convergence.error(BAND, 1.0))
                .as("no more than a thousandth or so of what is heard")
                .isCloseTo(Levels.ofRatio(1 + most), within(1e-5));
    }

    @Test
    void silenceIsNeverKnown() {
        between(1, Set.of(1));
        trace(8000, 1);
        assertThat(convergence.error(0, 0.0)).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(convergence.isAccurate(0, 0.0, 10)).isFalse();
        assertThat(convergence.isReached(0, 0.0)).isFalse();
    }

    /** Two places times four in which the ends are heard over ground and beside a wall, and the largest fraction. */
    @Test
    void theAllowanceIsThatOfTheScatterersNearTheEnds() {
        between(10, Set.of(0, 1));
        assertThat(missed.contribution(BAND)).isCloseTo(8 * 0.9 / (Math.PI * 100), within(1e-12));
        assertThat(missed.contribution(EnergyTally.A_WEIGHTED))
                .isCloseTo(Levels.toRatio(OctaveBands.aWeight(BAND)) * missed.contribution(BAND), within(1e-12));
        assertThat(missed.contribution(0)).as("the source has no sound there").isZero();
        between(10, Set.of(0));
        assertThat(missed.contribution(BAND)).isCloseTo(8 * 0.8 * 0.5 / (Math.PI * 100), within(1e-12));
        between(10, Set.of());
        assertThat(missed.contribution(BAND)).isZero();
        between(0.1, Set.of(1));
        assertThat(missed.contribution(BAND)).as("as from 1 m").isCloseTo(8 * 0.9 / Math.PI, within(1e-12));
    }

    /** The inequality from which it follows that E / (pi r^2) is the most by a single scattering. */
    @Test
    void distancesToASurfaceOverTheirCosinesAreNotBelowThatOfTheEnds() {
        SplittableRandom random = new SplittableRandom(20261127);
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < 200_000; i++) {
            // The surface is the plane z = 0; it scatters at the origin.
            Position one = new Position(random.nextDouble(-9, 9), random.nextDouble(-9, 9), random.nextDouble(9));
            Position other = new Position(random.nextDouble(-9, 9), random.nextDouble(-9, 9), random.nextDouble(9));
            double sum = Math.pow(one.length(), 3) / one.z() + Math.pow(other.length(), 3) / other.z();
            double distance = one.distance(other);
            least = Math.min(least, sum / (distance * distance));
        }
        assertThat(least).as("seed 20261127").isBetween(1.0, 1.2);
    }

    /** A wall that scatters everything, at 1.4 km from both ends, is met by no ray and heard by nobody. */
    @Test
    void aFarScattererDoesNotChangeTheError() {
        SurfaceMaterial near = wall("near", 0.0);
        SurfaceMaterial far = wall("far", 1.0);
        World alone = Sites.world(List.of(screen()), List.of(near));
        World both = Sites.world(List.of(screen(), Sites.box(1000, 1000, 0, 1004, 1004, 4)), List.of(near, far));
        assertThat(behindTheScreen(alone).standardError()).isLessThan(1e-3);
        assertThat(behindTheScreen(both).standardError()).isLessThan(1e-3);
        World beside = Sites.world(List.of(screen(), Sites.box(-4, -2, 0, -3, 2, 4)), List.of(near, far));
        assertThat(behindTheScreen(beside).standardError()).isGreaterThan(0.04);
    }

    private static TriangleMesh screen() {
        return World.merge(List.of(Sites.square(300, 0), Sites.box(0, -100, 0, 0.3, 100, 10)));
    }

    private static EnergyReading behindTheScreen(World world) {
        return new EnergyTracer(EnergyModel.DEFAULT, new Position(-0.8, 0, 1.5), 0.5, world)
                .trace(Sites.broadband(new Position(50, 3, 1.5)), new SplittableRandom(3), RayRecorder.NONE);
    }
}
