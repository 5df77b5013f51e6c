package org.dronewatch.sensor.rf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.assess;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.open;

import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.dronewatch.drone.Bursts;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RadioLink;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Signal;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** Noise that others make, signals that come in bursts, and signals that are like those of phones. */
class RadioFloorTest {
    private static final RfSettings RECEIVER = RfSettings.at(new Position(0, 0, 0));
    private static final double KT = 10.0 * Math.log10(1.380649e-23 * 290.0 * 1000.0);

    private static Drone emitting(double north, RadioLink link) {
        Position place = new Position(0, north, 0);
        DroneSettings settings =
                DroneSettings.of(ModelSettings.of("cube.obj"), Hover.at(place)).withRadio(link);
        return cube(settings, place, new Position(0, 0, 0));
    }

    private static double figure(ManMadeNoise noise, double megahertz) {
        return 10.0 * Math.log10(noise.ratio(megahertz * 1e6));
    }

    /** ITU-R P.372-17: c - d lg f with c, d = 76.8, 27.7; 72.5, 27.7; 67.2, 27.7; 53.6, 28.6. */
    @Test
    void manMadeNoiseIsThatOfP372() {
        assertThat(figure(ManMadeNoise.CITY, 1)).isCloseTo(76.8, within(1e-9));
        assertThat(figure(ManMadeNoise.RESIDENTIAL, 10)).isCloseTo(72.5 - 27.7, within(1e-9));
        assertThat(figure(ManMadeNoise.RURAL, 100)).isCloseTo(67.2 - 2 * 27.7, within(1e-9));
        assertThat(figure(ManMadeNoise.QUIET_RURAL, 10)).isCloseTo(53.6 - 28.6, within(1e-9));
        assertThat(figure(ManMadeNoise.CITY, 250)).isCloseTo(10.377, within(1e-3));
        // P.372-8: 44.3 - 12.3 lg f, from where both lines meet, at 10^(32.5 / 15.4) = 128.9 MHz, to 900 MHz.
        double meets = Math.pow(10.0, 32.5 / 15.4);
        assertThat(figure(ManMadeNoise.BUSINESS, meets)).isCloseTo(figure(ManMadeNoise.CITY, meets), within(1e-9));
        assertThat(figure(ManMadeNoise.BUSINESS, 433)).isCloseTo(11.87, within(0.005));
        assertThat(figure(ManMadeNoise.BUSINESS, 868)).isCloseTo(8.16, within(0.005));
    }

    /** There is no figure outside, and no antenna near the ground is colder than it. */
    @Test
    void elsewhereTheNoiseIsThatOfTheReceiver() {
        for (ManMadeNoise noise : ManMadeNoise.values()) {
            assertThat(noise.ratio(0.29e6)).isEqualTo(1.0);
            assertThat(noise.ratio(noise.highestFrequency() + 1.0)).isEqualTo(1.0);
            assertThat(noise.ratio(2.4e9)).isEqualTo(1.0);
            assertThat(RECEIVER.withEnvironment(noise).noise(2.4e9)).isEqualTo(RECEIVER.noise());
        }
        assertThat(ManMadeNoise.QUIET_RURAL.ratio(200e6)).isEqualTo(1.0);
        assertThat(RECEIVER.withEnvironment(ManMadeNoise.CITY).advice()).hasSize(1);
        assertThat(RECEIVER.withFrequencies(30e6, 6e9)
                        .withEnvironment(ManMadeNoise.CITY)
                        .advice())
                .isEmpty();
        assertThat(RECEIVER.advice()).isEmpty();
    }

    /** P.372: the factors of antenna and receiver add up, less one: 21.4 dB and 6 dB at 100 MHz give 21.49 dB. */
    @Test
    void noiseOfAntennaAndReceiverAddUp() {
        RfSettings city = RECEIVER.withFrequencies(30e6, 6e9).withEnvironment(ManMadeNoise.CITY);
        double factor = Math.pow(10, 2.14) + Math.pow(10, 0.6) - 1.0;
        assertThat(city.noise(100e6)).isCloseTo(KT + 70.0 + 10.0 * Math.log10(factor), within(1e-6));
        assertThat(10.0 * Math.log10(factor)).isCloseTo(21.49, within(0.005));

        Drone drone = emitting(1000, RadioLink.DEFAULT.withFrequency(100e6));
        double quiet =
                assess(RECEIVER.withFrequencies(30e6, 6e9), open(), drone).quantity();
        assertThat(quiet - assess(city, open(), drone).quantity()).isCloseTo(21.49 - 6.0, within(0.005));
    }

    /** Brute force: bursts on random channels from a random moment on, and dwells at random moments. */
    @Test
    void interceptionIsThatOfSimulatedBursts() {
        long seed = 20261125;
        System.out.println("seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 40; i++) {
            double period = random.nextDouble(0.002, 0.02);
            double duty = i % 4 == 0 ? 1.0 : random.nextDouble(0.05, 1.0);
            int channels = i % 5 == 0 ? 1 : random.nextInt(2, 80);
            Bursts bursts = Bursts.of(1.0 / period).withDutyCycle(duty).withChannels(channels, channels * 1e6);
            if (channels == 1 && duty == 1.0) {
                continue;
            }
            int heard = random.nextInt(1, channels + 1);
            double time = random.nextDouble(0.001, 0.05);
            double overlap = random.nextDouble() * 0.5 * Math.min(time, duty * period);
            int count = 1 + i % 3;
            Dwell dwell = Dwell.of(time).withOverlap(overlap).withCount(count);
            int looks = 20_000;
            int hits = 0;
            for (int look = 0; look < looks; look++) {
                boolean hit = false;
                for (int k = 0; k < count; k++) {
                    hit |= hears(random, period, duty * period, time, overlap, (double) heard / channels);
                }
                hits += hit ? 1 : 0;
            }
            double wanted = dwell.probability(bursts, heard * 1e6);
            double deviation = Math.sqrt(Math.max(wanted * (1.0 - wanted), 1e-4) / looks);
            assertThat((double) hits / looks)
                    .as("case %d: %s, %s", i, bursts, dwell)
                    .isCloseTo(wanted, within(4.5 * deviation));
        }
    }

    private static boolean hears(
            SplittableRandom random, double period, double duration, double time, double overlap, double share) {
        double start = -duration - period * random.nextDouble();
        boolean hit = false;
        for (double begin = start; begin < time; begin += period) {
            double common = Math.min(time, begin + duration) - Math.max(0.0, begin);
            hit |= common >= overlap && common > 0.0 && random.nextDouble() < share;
        }
        return hit;
    }

    /** Figures that one can check by hand. */
    @Test
    void simpleInterceptions() {
        // 80 channels in 80 MHz, 10 MHz heard, 100 hops a second, 30 ms: 4 hops, each heard one time in eight.
        Bursts hops = Bursts.of(100).withChannels(80, 80e6);
        assertThat(Dwell.of(0.03).probability(hops, 10e6)).isCloseTo(1 - Math.pow(7.0 / 8.0, 4), within(1e-12));
        assertThat(Dwell.of(0.03).probability(hops, 80e6)).isEqualTo(1.0);
        // One burst of 1 ms a second, a dwell of 99 ms: a tenth of the looks.
        Bursts seldom = Bursts.of(1).withDutyCycle(0.001);
        assertThat(Dwell.of(0.099).probability(seldom, 10e6)).isCloseTo(0.1, within(1e-12));
        assertThat(Dwell.of(0.099).withOverlap(0.002).probability(seldom, 10e6)).isZero();
        assertThat(Dwell.of(1e-6).probability(Bursts.of(50), 1.0)).isEqualTo(1.0);
    }

    /** Looks of a run detect as often as is said of one. */
    @Test
    void looksDetectAsOftenAsTheirProbability() {
        Bursts hops = Bursts.of(50).withDutyCycle(0.5).withChannels(40, 80e6);
        RadioLink link = RadioLink.DEFAULT.withBursts(hops).withPilot(new Position(300, 0, 0));
        RfSettings receiver = RECEIVER.withDwell(Dwell.of(0.02)).withOccupied("wlan", OccupiedBand.of(-60.0, 0.3));
        Drone drone = emitting(2000, link);
        World world = open();
        Signal signal = assess(receiver, world, drone).signal();
        assertThat(signal.probability()).isBetween(0.05, 0.6);
        RfSensor sensor = receiver.create();
        int hits = 0;
        int count = 4000;
        TreeSet<Double> rises = new TreeSet<>();
        for (int look = 0; look < count; look++) {
            Observation seen = sensor.observe(world, List.of(drone), Look.of(5, "sensor", look, look))
                    .get(0);
            assertThat(seen.probability()).isEqualTo(signal.probability());
            rises.add(seen.figures().get("interference_db"));
            hits += seen.isDetected() ? 1 : 0;
        }
        assertThat(rises).hasSize(2);
        double deviation = Math.sqrt(signal.probability() * (1.0 - signal.probability()) / count);
        assertThat((double) hits / count).isCloseTo(signal.probability(), within(4.0 * deviation));
    }

    /** -60 dBm in each of 10 MHz over a noise of -98 dBm: the noise rises by 48 dB while WLAN transmits. */
    @Test
    void anOccupiedBandRaisesTheNoise() {
        RfSettings always = RECEIVER.withOccupied("wlan", OccupiedBand.of(-60.0, 1.0));
        Drone drone = emitting(100, RadioLink.DEFAULT);
        double less = assess(RECEIVER, open(), drone).quantity()
                - assess(always, open(), drone).quantity();
        double exact = 10.0 * Math.log10(1.0 + Math.pow(10.0, 0.1 * (-50.0 - RECEIVER.noise())));
        assertThat(less).isCloseTo(exact, within(1e-9)).isBetween(47.9, 48.1);
        assertThat(assess(always, open(), drone).cause()).isEqualTo(Cause.TOO_WEAK);
        // In other bands nothing changes, and where others transmit seldom only few looks are lost.
        Drone elsewhere = emitting(100, RadioLink.DEFAULT.withFrequency(868e6));
        assertThat(assess(always, open(), elsewhere)).isEqualTo(assess(RECEIVER, open(), elsewhere));
        Assessment seldom = assess(RECEIVER.withOccupied("wlan", OccupiedBand.of(-60.0, 0.2)), open(), drone);
        assertThat(seldom.probability()).isCloseTo(0.8, within(1e-12));
        assertThat(seldom.quantity()).isEqualTo(assess(RECEIVER, open(), drone).quantity());
        assertThat(seldom.cause()).isEqualTo(Cause.DETECTED);
    }

    /** A phone's signal is received as well as any other, and says nothing, unless the receiver is given it. */
    @Test
    void aDroneOnAMobileNetworkIsLikeAPhone() {
        RadioLink phone = RadioLink.DEFAULT.withFrequency(847e6).withEmission(RadioLink.Emission.CELLULAR);
        Drone drone = emitting(200, phone);
        assertThat(assess(RECEIVER, open(), drone).cause()).isEqualTo(Cause.SILENT);
        assertThat(assess(RECEIVER, open(), drone).quantity()).isEqualTo(Double.NEGATIVE_INFINITY);
        RfSettings told = RECEIVER.withRecognised(List.of(RadioLink.Emission.CELLULAR));
        assertThat(assess(told, open(), drone).cause()).isEqualTo(Cause.DETECTED);
        assertThat(assess(told, open(), emitting(200, RadioLink.DEFAULT)).cause())
                .isEqualTo(Cause.SILENT);
        assertThat(assess(told, open(), emitting(50_000, phone)).cause()).isEqualTo(Cause.TOO_WEAK);
        // Among the phones of the band it drowns.
        RfSettings crowded =
                told.withOccupied("phones", OccupiedBand.of(-50.0, 0.9).withBand(RadioBand.LTE_800_UPLINK));
        assertThat(assess(crowded, open(), drone).cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(assess(crowded, open(), drone).probability()).isCloseTo(0.1, within(1e-12));
        assertThat(assess(RECEIVER, open(), emitting(200, RadioLink.DEFAULT.withEmission(RadioLink.Emission.WLAN)))
                        .cause())
                .isEqualTo(Cause.DETECTED);
    }

    @Test
    void impossibleFloorsAreRefused() {
        assertThatThrownBy(() ->
                        RECEIVER.withOccupied("a", OccupiedBand.of(-60, 1)).withOccupied("b", OccupiedBand.of(-70, 1)))
                .hasMessageContaining("occupied bands 'a' and 'b' overlap");
        assertThatThrownBy(() -> Dwell.of(0.01).withOverlap(0.02)).hasMessageContaining("must be at most time");
        assertThatThrownBy(() -> Bursts.of(0)).hasMessageStartingWith("rate");
        assertThatThrownBy(() -> OccupiedBand.of(-60, 1.5)).hasMessageStartingWith("occupancy");
        assertThat(Map.of()).isEqualTo(RECEIVER.occupied());
    }
}
