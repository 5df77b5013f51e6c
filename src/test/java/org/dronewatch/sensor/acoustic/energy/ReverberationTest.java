package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceMaterial.Wall;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

class ReverberationTest {
    private static final Position SENSOR = new Position(7, 5, 1.7);
    private static final Position DRONE = new Position(2, 3, 1.5);

    /** Absorbs more in each band than in the one below; scatters all. */
    private static final List<Double> ABSORPTION = List.of(0.1, 0.12, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4);

    private static Reverberation measure(World room, long seed) {
        EnergyTracer tracer = new EnergyTracer(Reverberation.patient(EnergyModel.DEFAULT), SENSOR, 0.5, room);
        return Reverberation.measure(tracer, Sites.broadband(DRONE), new SplittableRandom(seed), 0.5);
    }

    /** Relative variance of the free paths in a cube whose walls scatter (Kuttruff, Room Acoustics, table 5.1). */
    private static final double VARIANCE = 0.34;

    /**
     * A nearly cubic room of diffuse walls has the reverberation time of Eyring (JASA 1, 217, 1930), with its air, as
     * Kuttruff corrects it for free paths of different lengths (Room Acoustics, section 5.5).
     */
    @Test
    void eachBandHasItsTime() {
        SurfaceMaterial wall = new SurfaceMaterial(
                "wall",
                ABSORPTION,
                Collections.nCopies(OctaveBands.COUNT, 1.0),
                List.of(),
                Wall.SHEET,
                OptionalDouble.empty(),
                "test");
        World room = Sites.world(Sites.room(9, 8, 7), wall);
        Reverberation found = measure(room, 5);
        double volume = 9 * 8 * 7;
        double surface = 2 * (9 * 8 + 9 * 7 + 8 * 7);
        double[] air = room.atmosphere().attenuations();
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double exponent = -Math.log(1 - ABSORPTION.get(band));
            double loss = surface * exponent * (1 - VARIANCE / 2 * exponent) + 4 * volume * air[band] / 4.343;
            double expected = 24 * Math.log(10) * volume / (room.atmosphere().speedOfSound() * loss);
            Reverberation.Time time = found.time(band).orElseThrow();
            assertThat(time.seconds())
                    .as("%d Hz, standard error %.3f s", OctaveBands.nominal(band), time.error())
                    .isCloseTo(expected, within(0.02 * expected + 2 * time.error()));
        }
    }

    /**
     * Over 24 seeds (40 in the long form), times scatter as much as they say: the limits are those of the energy
     * model's other errors.
     */
    @Thorough
    @Test
    void theErrorIsHonest() {
        World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.2, 0.3));
        int seeds = LongForm.count(24, 40);
        double sum = 0;
        double squares = 0;
        double stated = 0;
        for (int seed = 0; seed < seeds; seed++) {
            Reverberation.Time time = measure(room, 100 + seed).time().orElseThrow();
            assertThat(time.error()).isLessThanOrEqualTo(0.02 * time.seconds());
            sum += time.seconds();
            squares += time.seconds() * time.seconds();
            stated += time.error() / seeds;
        }
        double deviation = Math.sqrt((squares - sum * sum / seeds) / (seeds - 1));
        assertThat(deviation / stated).as("stated %.4f s", stated).isBetween(0.8, 1.25);
    }

    /** In the open there is none, and one group of rays is enough to know that. */
    @Test
    void inTheOpenNothingReverberates() {
        World plane = Sites.world(Sites.square(100, 0), SurfaceMaterial.uniform("ground", 0.2, 0.3));
        Reverberation found = measure(plane, 1);
        assertThat(found.escaped()).isGreaterThan(0.5);
        assertThat(found.time()).isEmpty();
    }
}
