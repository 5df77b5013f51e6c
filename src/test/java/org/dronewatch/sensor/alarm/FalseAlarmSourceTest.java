package org.dronewatch.sensor.alarm;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.array.ArraySettings;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.camera.TargetTask;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarDetection;
import org.dronewatch.sensor.radar.RadarFalseAlarms;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.sensor.rf.RfSettings;
import org.dronewatch.sensor.thermal.ThermalSettings;
import org.dronewatch.world.Weather;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What sensors report although there is nothing. */
class FalseAlarmSourceTest {
    private static final long SEED = 4_711L;
    private static final Weather FAIR = new Weather(0.0, 0.0, 20_000.0, 5_000.0);

    private static final Position PLACE = new Position(1, 2, 3);
    private static final World WORLD =
            World.of(TriangleMesh.of(new float[] {-9, -9, -9, 9, -9, -9, 9, 9, -9}, new int[] {0, 1, 2}));
    private static final int BINS = 20;

    /** Of a chi-square distribution with 19 degrees of freedom: exceeded once in 100,000 (tables: 61.7). */
    private static final double IMPROBABLE = 61.7;

    private static List<Observation> observe(SensorSettings<?> sensor, int looks) {
        FalseAlarmSource source = FalseAlarmSource.of(sensor, FAIR).orElseThrow();
        List<Observation> all = new ArrayList<>();
        for (int i = 0; i < looks; i++) {
            all.addAll(source.observe(WORLD, Look.of(SEED, "watch", i, i / sensor.rate())));
        }
        return all;
    }

    private static RadarSettings radar() {
        return RadarSettings.at(PLACE, LinkBudget.DataSheet.of(1000, 0.01))
                .withRanges(100, 2000)
                .withFieldOfView(Math.toRadians(90), Math.toRadians(60))
                .withAim(new Aim.Direction(1.0, 0.6))
                .withDetection(new RadarDetection.Chance(1e-4, 1))
                .withFalseAlarms(RadarFalseAlarms.DEFAULT.withCells(20_000).withGate(10));
    }

    private static void assertUniform(
            List<Observation> all, double low, double high, ToDoubleFunction<Sighting> value) {
        int[] counts = new int[BINS];
        for (Observation one : all) {
            double share = (value.applyAsDouble(one.sighting().orElseThrow()) - low) / (high - low);
            counts[(int) Math.min(BINS - 1.0, share * BINS)]++;
        }
        double expected = (double) all.size() / BINS;
        double chiSquare = 0.0;
        for (int count : counts) {
            chiSquare += (count - expected) * (count - expected) / expected;
        }
        System.out.printf("%d false alarms, chi-square %.1f%n", all.size(), chiSquare);
        assertThat(chiSquare).isBetween(1.0, IMPROBABLE);
    }

    /**
     * The number in many looks is Poisson-distributed: within four of its standard deviations, for small and large
     * means.
     */
    @Test
    void asManyAsTheRateStates() {
        System.out.println("seed " + SEED);
        for (double perLook : new double[] {0.003, 0.7, 29.0, 31.0, 250.0}) {
            RfSettings sensor = RfSettings.at(PLACE).withFalseAlarms(new FalseAlarms(3600.0 * perLook, 5, 0.0));
            int looks = (int) Math.min(200_000, 40_000 / perLook);
            double expected = looks * perLook;
            int counted = observe(sensor, looks).size();
            System.out.printf("%d of %.1f%n", counted, expected);
            assertThat((double) counted).isCloseTo(expected, within(4.0 * Math.sqrt(expected)));
        }
    }

    /** Mean and variance of a Poisson distribution are equal. */
    @Test
    void theNumberInALookIsPoissonDistributed() {
        SplittableRandom random = new SplittableRandom(SEED);
        for (double mean : new double[] {0.0, 0.2, 3.0, 75.0}) {
            int draws = 100_000;
            double sum = 0.0;
            double squares = 0.0;
            for (int i = 0; i < draws; i++) {
                double count = FalseAlarmSource.poisson(mean, random);
                sum += count;
                squares += count * count;
            }
            double variance = squares / draws - sum / draws * (sum / draws);
            assertThat(sum / draws).isCloseTo(mean, within(4.0 * Math.sqrt(mean / draws)));
            // The variance of a sample's variance is (mean + 2 mean^2) / draws.
            assertThat(variance).isCloseTo(mean, within(4.0 * Math.sqrt((mean + 2.0 * mean * mean) / draws)));
        }
    }

    private static RandomGenerator drawing(double draw) {
        return new RandomGenerator() {
            @Override
            public long nextLong() {
                throw new UnsupportedOperationException("only one fraction is drawn");
            }

            @Override
            public double nextDouble() {
                return draw;
            }
        };
    }

    /** Of mean 1, by hand: none up to 1/e, one up to 2/e, two up to 2.5/e. */
    @ParameterizedTest
    @CsvSource({"0, 0", "0.3678, 0", "0.3679, 1", "0.7357, 1", "0.7359, 2", "0.9196, 2", "0.9198, 3"})
    void theNumberIsTheFirstWhoseCumulativeProbabilityExceedsTheDraw(double draw, int count) {
        assertThat(FalseAlarmSource.poisson(1.0, drawing(draw))).isEqualTo(count);
    }

    /** As many of the draws, which include 0 and exclude 1, as the probability says. */
    @Test
    void aDrawThatEqualsTheProbabilityOfNoneGivesOne() {
        double none = Math.exp(-2.0);
        assertThat(FalseAlarmSource.poisson(2.0, drawing(Math.nextDown(none)))).isZero();
        assertThat(FalseAlarmSource.poisson(2.0, drawing(none))).isEqualTo(1);
        assertThat(FalseAlarmSource.poisson(0.0, drawing(Math.nextDown(1.0)))).isZero();
    }

    /** Rounded probabilities may add up to less than the largest draw: even then there is an end. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 0.1, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 29.0, 30.0})
    void theLargestDrawGivesAFiniteNumber(double mean) {
        int largest = FalseAlarmSource.poisson(mean, drawing(Math.nextDown(1.0)));
        assertThat(largest).isBetween(FalseAlarmSource.poisson(mean, drawing(0.999)) + 1, 500);
    }

    @Test
    void thoseOfARadarFillItsFieldCellByCell() {
        List<Observation> all = observe(radar(), 20_000);
        assertUniform(all, 100, 2000, sighting -> sighting.range().orElseThrow());
        assertUniform(all, 1.0 - Math.PI / 4, 1.0 + Math.PI / 4, sighting -> sighting.direction()
                .azimuth());
        double half = Math.toRadians(30);
        assertUniform(
                all,
                Math.sin(0.6 - half),
                Math.sin(0.6 + half),
                sighting -> Math.sin(sighting.direction().elevation()));
        for (Observation one : all) {
            Position seen = one.sighting().orElseThrow().position().orElseThrow();
            assertThat(radar().outline().contains(seen.minus(PLACE))).isTrue();
        }
    }

    /** Noise power beyond a threshold is exponentially distributed with the mean power: median ln 2 above it. */
    @Test
    void noisePassesTheThresholdByALittle() {
        List<Observation> all = observe(radar(), 5000);
        double least = -Math.log(1e-4);
        int above = 0;
        for (Observation one : all) {
            assertThat(one.isDetected()).isTrue();
            assertThat(Math.pow(10.0, 0.1 * one.threshold())).isCloseTo(least, within(1e-9));
            above += Math.pow(10.0, 0.1 * one.value()) > least + Math.log(2.0) ? 1 : 0;
        }
        double sigma = 0.5 * Math.sqrt(all.size());
        assertThat((double) above).isCloseTo(0.5 * all.size(), within(4.0 * sigma));
    }

    /** Brute force: sums of four exponential powers, of which one in a hundred passes the threshold. */
    @Test
    void noiseInManyPulses() {
        double threshold = new RadarDetection.Chance(0.01, 4).noise(0.0).threshold();
        SplittableRandom random = new SplittableRandom(SEED);
        int draws = 400_000;
        int above = 0;
        for (int i = 0; i < draws; i++) {
            double sum = 0.0;
            for (int k = 0; k < 4; k++) {
                sum -= Math.log1p(-random.nextDouble());
            }
            above += sum / 4 > Math.pow(10.0, 0.1 * threshold) ? 1 : 0;
        }
        assertThat((double) above).isCloseTo(0.01 * draws, within(4.0 * Math.sqrt(0.01 * draws)));
    }

    @Test
    void thoseOfACameraFillItsImage() {
        CameraSettings camera = CameraSettings.at(PLACE)
                .withLookAt(new Position(100, 2, 3))
                .withHorizontalFov(Math.toRadians(60))
                .withRate(1)
                .withFalseAlarms(new FalseAlarms(3600, 40, 0));
        List<Observation> all = observe(camera, 20_000);
        // Pixels are equally wide in the tangent of the angle to the axis, which points east.
        double edge = Math.tan(Math.toRadians(30));
        assertUniform(all, -edge, edge, sighting -> {
            Position to = sighting.direction().unit();
            return -to.y() / to.x();
        });
        assertThat(all).allMatch(one -> one.value() == 12.0 && one.isDetected());
        assertThat(camera.falseBearings().orElseThrow().width()).isCloseTo(Math.toRadians(60), within(1e-3));
    }

    @Test
    void aCameraOnAPositionerReportsThemWhereItPoints() {
        CameraSettings camera = CameraSettings.at(PLACE)
                .withRate(1)
                .withPositioner(PositionerSettings.DEFAULT)
                .withFalseAlarms(new FalseAlarms(36_000, 1, 0));
        Pointing south = new Pointing(new Direction(Math.PI, 0.1), 0, 0, 0.05, java.util.OptionalInt.empty());
        FalseAlarmSource source = FalseAlarmSource.of(camera, FAIR).orElseThrow();
        List<Observation> seen =
                source.observe(WORLD, Look.of(SEED, "watch", 0, 0).withPointing(Optional.of(south)));
        assertThat(seen).isNotEmpty().allSatisfy(one -> {
            Direction to = one.sighting().orElseThrow().direction();
            assertThat(Math.abs(Math.IEEEremainder(to.azimuth() - Math.PI, 2 * Math.PI)))
                    .isLessThan(0.05);
            assertThat(to.elevation()).isBetween(0.07, 0.13);
        });
        assertThat(camera.falseBearings()).isEmpty();
    }

    @Test
    void thoseOfAnArrayComeFromAboveTheHorizonAndThoseOfAMicrophoneFromNowhere() {
        FalseAlarms often = new FalseAlarms(7200, 3, 0);
        AcousticSettings single = AcousticSettings.at(PLACE).withRate(1).withFalseAlarms(often);
        AcousticSettings array = single.withPropagation(EnergyModel.DEFAULT).withArray(ArraySettings.of(16, 1));
        List<Observation> heard = observe(array, 10_000);
        assertUniform(heard, -Math.PI, Math.PI, sighting -> sighting.direction().azimuth());
        assertUniform(heard, 0, 1, sighting -> Math.sin(sighting.direction().elevation()));
        assertThat(observe(single, 100))
                .isNotEmpty()
                .allMatch(one -> one.sighting().isEmpty() && one.isDetected());
    }

    /** All false alarms of one cell lie close together, and those of a thermal camera just reach its probability. */
    @Test
    void onePlaceIsAPartOfTheField() {
        ThermalSettings camera = ThermalSettings.at(PLACE).withFalseAlarms(new FalseAlarms(900_000, 400, 0));
        List<Observation> ofOne = observe(camera, 2000).stream()
                .filter(one -> one.figures().get(FalseAlarmSource.CELL) == 7.0)
                .toList();
        assertThat(ofOne).hasSizeGreaterThan(10);
        Position first = ofOne.get(0).sighting().orElseThrow().direction().unit();
        // 24 x 19 degrees in 400 cells: 1.5 x 0.6 degrees each.
        assertThat(ofOne)
                .allMatch(one -> Math.toDegrees(
                                one.sighting().orElseThrow().direction().unit().angle(first))
                        < 1.8);
        assertThat(ofOne).allMatch(one -> one.value() == 0.5 && one.threshold() == 0.5);
    }

    @Test
    void whatLastsKeepsItsPlaceForAsManyLooks() {
        CameraSettings camera = CameraSettings.at(PLACE).withRate(4).withFalseAlarms(new FalseAlarms(1200, 1000, 2.5));
        List<Observation> all = observe(camera, 40_000);
        long begun = all.stream().filter(FalseAlarmSource::isNew).count();
        // 10 looks each, apart from those at both ends; 1/3 a second begin in 10,000 s.
        assertThat((double) all.size()).isCloseTo(10.0 * begun, within(200.0));
        assertThat((double) begun).isCloseTo(10_000 / 3.0, within(4.0 * Math.sqrt(10_000 / 3.0)));
        Observation first = all.stream()
                .filter(one -> FalseAlarmSource.isNew(one) && one.look().index() > 20)
                .findFirst()
                .orElseThrow();
        List<Observation> same = all.stream()
                .filter(one -> one.sighting().equals(first.sighting()))
                .toList();
        assertThat(same).hasSize(10);
        assertThat(same.get(9).look().index()).isEqualTo(first.look().index() + 9);
    }

    /** At the first look there are as many as at any other. */
    @Test
    void somethingIsThereAlreadyWhenTheRunBegins() {
        RfSettings sensor = RfSettings.at(PLACE).withFalseAlarms(new FalseAlarms(3600, 1, 100));
        int sum = 0;
        for (int i = 0; i < 200; i++) {
            List<Observation> first =
                    FalseAlarmSource.of(sensor, FAIR).orElseThrow().observe(WORLD, Look.of(i, "x", 0, 0));
            assertThat(first).allMatch(FalseAlarmSource::isNew);
            sum += first.size();
        }
        assertThat((double) sum).isCloseTo(20_000, within(4.0 * Math.sqrt(20_000)));
    }

    /** What has begun before, and what begins now, does not depend on who has watched since when. */
    @ParameterizedTest
    @ValueSource(doubles = {0.0, 1.0, 5.0, 30.0})
    void aSourceThatBeginsLaterReportsTheSame(double duration) {
        RfSettings sensor = RfSettings.at(PLACE).withFalseAlarms(new FalseAlarms(7200, 1000, duration));
        FalseAlarmSource early = FalseAlarmSource.of(sensor, FAIR).orElseThrow();
        int count = 0;
        for (int i = 0; i < 40; i++) {
            Look look = Look.of(SEED, "watch", i, i);
            List<Observation> seen = early.observe(WORLD, look);
            FalseAlarmSource late = FalseAlarmSource.of(sensor, FAIR).orElseThrow();
            assertThat(late.observe(WORLD, look)).as("look %d", i).isEqualTo(seen);
            count += seen.size();
        }
        assertThat(count).isGreaterThan(40);
    }

    @Test
    void theSameSeedGivesTheSame() {
        assertThat(observe(radar(), 50)).isEqualTo(observe(radar(), 50));
        CameraSettings chance =
                CameraSettings.at(PLACE).withDetection(TargetTask.DEFAULT).withFalseAlarms(FalseAlarms.of(1e5));
        assertThat(observe(chance, 50)).isEqualTo(observe(chance, 50)).allMatch(Observation::isDetected);
    }

    /**
     * With 60 in calm and dry hours, 1,800 in rain, and 7,200 in wind, rainy or not, whichever is stated first: Poisson
     * numbers.
     */
    @ParameterizedTest
    @CsvSource({"0, 0, 60", "1.9, 7.9, 60", "2, 0, 1800", "0, 8, 7200", "2, 20, 7200"})
    void asManyAsTheHighestRateOfTheWeather(double rain, double wind, double perHour) {
        List<WeatherRate> rates = new ArrayList<>(List.of(
                WeatherRate.of(1800.0).withRain(2.0), WeatherRate.of(7200.0).withWind(8.0)));
        FalseAlarms alarms = new FalseAlarms(60.0, 1, 0.0).withWeather(rates);
        Collections.reverse(rates);
        Weather weather = new Weather(rain, wind, 20_000.0, 5_000.0);
        assertThat(alarms.in(weather)).isEqualTo(alarms.withWeather(rates).in(weather));
        SensorSettings<?> sensor = RfSettings.at(PLACE).withFalseAlarms(alarms);
        FalseAlarmSource source = FalseAlarmSource.of(sensor, weather).orElseThrow();
        double hours = 2.0;
        int count = 0;
        for (int i = 0; i < hours * 3600.0 * sensor.rate(); i++) {
            count += source.observe(WORLD, Look.of(SEED, "ear", i, i / sensor.rate()))
                    .size();
        }
        double expected = perHour * hours;
        assertThat((double) count).as("seed %d", SEED).isCloseTo(expected, within(4.0 * Math.sqrt(expected)));
    }

    /** All conditions count; in haze and at night are up to a limit, rain and wind from one on. */
    @Test
    void aRateAppliesWhereTheWeatherMeetsItsConditions() {
        WeatherRate misty = WeatherRate.of(5.0).withVisibility(1000.0).withIlluminance(10.0);
        assertThat(misty.appliesIn(new Weather(0, 0, 1000.0, 10.0))).isTrue();
        assertThat(misty.appliesIn(new Weather(500, 60, 1.0, 1e-5))).isTrue();
        assertThat(misty.appliesIn(new Weather(0, 0, 1001.0, 10.0))).isFalse();
        assertThat(misty.appliesIn(new Weather(0, 0, 1000.0, 11.0))).isFalse();
        assertThat(WeatherRate.of(5.0).appliesIn(new Weather(0, 0, 1e6, 200_000)))
                .isTrue();
        assertThat(WeatherRate.of(5.0).withRain(1e-3).appliesIn(FAIR)).isFalse();
        // Too many are too many in any weather.
        FalseAlarms storm =
                FalseAlarms.of(1.0).withWeather(List.of(WeatherRate.of(1e7).withWind(30.0)));
        assertThatThrownBy(() -> RfSettings.at(PLACE).withFalseAlarms(storm))
                .hasMessageContaining("there must be 0 to 1000");
    }

    /** A quieter night, stated alone, is quieter: the rate of fair weather is not another that applies. */
    @Test
    void aRateMayBeLowerThanThatOfFairWeather() {
        FalseAlarms alarms =
                FalseAlarms.of(20.0).withWeather(List.of(WeatherRate.of(3.0).withIlluminance(1.0)));
        assertThat(alarms.in(new Weather(0, 0, 20_000, 0.2)).perHour()).isEqualTo(3.0);
        assertThat(alarms.in(FAIR).perHour()).isEqualTo(20.0);
    }

    /** By brute force over all weather: an entry that is warned of may be removed, one that is not may not. */
    @Test
    void entriesThatMakeNoDifferenceAreWarnedOf() {
        SplittableRandom random = new SplittableRandom(SEED);
        int idle = 0;
        for (int trial = 0; trial < 300; trial++) {
            List<WeatherRate> rates = new ArrayList<>();
            for (int i = 0; i < 4; i++) {
                rates.add(new WeatherRate(
                        random.nextInt(3),
                        random.nextInt(3),
                        random.nextInt(3),
                        random.nextBoolean() ? 1e6 : 1e3,
                        200_000));
            }
            FalseAlarms all = FalseAlarms.of(9.0).withWeather(rates);
            for (int i = 0; i < rates.size(); i++) {
                List<WeatherRate> others = new ArrayList<>(rates);
                others.remove(i);
                String start = "falseAlarms.weather." + i + " makes no difference";
                boolean isWarnedOf = all.advice().stream().anyMatch(line -> line.startsWith(start));
                // Of two equal entries, the first makes a difference once the second is gone.
                boolean isDouble = rates.subList(i + 1, rates.size()).contains(rates.get(i));
                assertThat(isWarnedOf || isDouble)
                        .as("seed %d, trial %d: %s without %d", SEED, trial, rates, i)
                        .isEqualTo(sameInAllWeather(all, all.withWeather(others)));
                idle += isWarnedOf ? 1 : 0;
            }
        }
        assertThat(idle).isBetween(300, 900);
    }

    private static boolean sameInAllWeather(FalseAlarms one, FalseAlarms other) {
        for (int rain = 0; rain < 3; rain++) {
            for (int wind = 0; wind < 3; wind++) {
                for (double visibility : new double[] {1e6, 1e3}) {
                    Weather weather = new Weather(rain, wind, visibility, 5_000);
                    if (one.in(weather).perHour() != other.in(weather).perHour()) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    @Test
    void anEntryWithoutConditionsIsWarnedOf() {
        FalseAlarms always = FalseAlarms.of(5.0).withWeather(List.of(WeatherRate.of(0.0)));
        assertThat(always.advice())
                .containsExactly("falseAlarms.weather.0 has no conditions, so it always applies and perHour never"
                        + " does: set rain, wind, visibility or illuminance");
        assertThat(always.withWeather(List.of(
                                WeatherRate.of(12.0).withRain(2.0),
                                WeatherRate.of(30.0).withRain(1.0)))
                        .advice())
                .containsExactly("falseAlarms.weather.0 makes no difference: whenever it applies, so does weather.1,"
                        + " whose rate is at least as high");
        assertThat(FalseAlarms.of(5.0).advice()).isEmpty();
    }

    @Test
    void whereNoRateIsKnownThereIsNothing() {
        assertThat(FalseAlarmSource.of(RfSettings.at(PLACE), FAIR)).isEmpty();
        assertThat(FalseAlarmSource.of(RfSettings.at(PLACE).withFalseAlarms(FalseAlarms.of(0)), FAIR))
                .isEmpty();
        assertThat(RfSettings.at(PLACE).withFalseAlarms(FalseAlarms.of(0)).falseAlarmRate())
                .isPresent();
    }

    @Test
    void limits() {
        assertThatThrownBy(() -> RfSettings.at(PLACE).withFalseAlarms(FalseAlarms.of(5e6)))
                .hasMessage(
                        "falseAlarms: 1388.8889 false alarms that begin in each look, each of which lasts for 5 looks,"
                                + " amount to 6944.4443 at the same time; there must be 0 to 1000");
        assertThatThrownBy(() -> RfSettings.at(PLACE).withFalseAlarms(new FalseAlarms(5e6, 1, 0)))
                .hasMessage(
                        "falseAlarms: 1388.8889 false alarms that begin in each look amount to 1388.8889 at the same time;"
                                + " there must be 0 to 1000");
        assertThat(RfSettings.at(PLACE)
                        .withFalseAlarms(new FalseAlarms(36_000, 1, 100))
                        .falseAlarmRate())
                .isPresent();
        assertThatThrownBy(() -> FalseAlarms.of(-1)).hasMessage("perHour -1 must be 0 to 1e7");
        assertThatThrownBy(() -> FalseAlarms.of(Double.NaN)).hasMessageContaining("perHour NaN");
        assertThatThrownBy(() -> FalseAlarms.of(1).withCells(0)).hasMessage("cells 0 must be 1 to 1e9");
    }
}
