package org.dronewatch.catalog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.dronewatch.catalog.CatalogEntry.PublishedRange;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.optics.FieldOfView;
import org.dronewatch.sensor.optics.PictureSettings;
import org.dronewatch.sensor.radar.LinkBudget.DataSheet;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.sensor.rf.RfSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The settings of each entry against what its source and its note state, and against physics, as far as they state
 * anything. What is checked for an entry is what the page about the catalogue lists: an entry that states less is
 * checked for less, and a check that stops to apply is missed.
 */
class CatalogConsistencyTest {
    private static final Path PAGE = Path.of("src/site/markdown/catalogue.md");
    private static final double LIGHT = 299_792_458.0;

    private static List<String> names() {
        return Catalog.packagedNames();
    }

    private static CatalogEntry entry(String name) {
        return Catalog.packaged().entry(name).orElseThrow();
    }

    /** What the page says is checked, by name of the entry. */
    private static Map<String, List<String>> listed() throws IOException {
        String table = Files.readString(PAGE).split("\\| checked \\|", 2)[1].split("\n\n", 2)[0];
        Map<String, List<String>> listed = new HashMap<>();
        table.lines().filter(line -> line.startsWith("| `")).forEach(line -> {
            String[] cells = line.split("\\|");
            List<String> checks = Arrays.asList(cells[2].strip().split(", "));
            Pattern.compile("`([^`]+)`").matcher(cells[1]).results().forEach(name -> listed.put(name.group(1), checks));
        });
        return listed;
    }

    @ParameterizedTest
    @MethodSource("names")
    void anEntryAgreesWithWhatItsSourceStates(String name) throws IOException {
        Map<String, Runnable> checks = checks(name);
        assertThat(checks.keySet()).containsExactlyInAnyOrderElementsOf(listed().get(name));
        checks.values().forEach(Runnable::run);
    }

    @Test
    void thePageListsEachEntryOnce() throws IOException {
        assertThat(listed().keySet()).containsExactlyInAnyOrderElementsOf(names());
    }

    private static Map<String, Runnable> checks(String name) {
        CatalogEntry entry = entry(name);
        SensorSettings<?> settings = Catalog.packaged().settings(name, Map.of("position", new Position(0, 0, 10)));
        Map<String, Runnable> checks = new LinkedHashMap<>();
        if (settings instanceof RadarSettings radar) {
            radar(entry, radar, checks);
        } else if (settings instanceof PictureSettings picture) {
            camera(name, entry, picture, checks);
        } else if (settings instanceof RfSettings receiver) {
            receiver(entry, receiver, checks);
        } else {
            microphones(entry, (AcousticSettings) settings, checks);
        }
        return checks;
    }

    private static Optional<MatchResult> stated(String text, String pattern) {
        return Pattern.compile(pattern)
                .matcher(text.replaceAll("\\s+", " "))
                .results()
                .findFirst();
    }

    private static double number(MatchResult match, int group) {
        return Double.parseDouble(match.group(group));
    }

    private static void radar(CatalogEntry entry, RadarSettings radar, Map<String, Runnable> checks) {
        MatchResult sector = stated(entry.coverage(), "(\\d+) x (\\d+) deg").orElseThrow();
        checks.put("sector", () -> {
            assertThat(Math.toDegrees(radar.azimuthWidth())).isCloseTo(number(sector, 1), within(1e-9));
            assertThat(Math.toDegrees(radar.elevationWidth())).isCloseTo(number(sector, 2), within(1e-9));
        });
        checks.put("range limits", () -> entry.ranges()
                .forEach(range -> assertThat(range.distance()).isBetween(radar.minRange(), radar.maxRange())));
        checks.put("accuracy", () -> assertThat(radar.accuracy().measuresElevation())
                .isEqualTo(!entry.note().replaceAll("\\s+", " ").contains("No source states that the radar measures")));
        stated(entry.source(), "([\\d.]+) to ([\\d.]+) GHz")
                .ifPresent(band -> checks.put("band", () -> assertThat(radar.frequency())
                        .isBetween(1e9 * number(band, 1), 1e9 * number(band, 2))));
        // IEEE 521: 12 to 18 GHz.
        stated(entry.source(), "Ku band")
                .ifPresent(band ->
                        checks.put("band", () -> assertThat(radar.frequency()).isBetween(12e9, 18e9)));
        stated(entry.source(), "up to (\\d+) scans/s")
                .ifPresent(scans ->
                        checks.put("scan rate", () -> assertThat(radar.rate()).isLessThanOrEqualTo(number(scans, 1))));
        stated(entry.source(), "tilt -(\\d+) to (\\d+) deg")
                .ifPresent(tilt -> checks.put("tilt", () -> assertThat(Math.toDegrees(radar.maxTilt()))
                        .isCloseTo(number(tilt, 2), within(1e-9))));
        stated(entry.source(), "([\\d.]+)(?: to [\\d.]+)? W\\b")
                .ifPresent(power -> checks.put("antenna area", () -> aperture(entry, radar, number(power, 1))));
        DataSheet sheet = (DataSheet) radar.budget();
        if (sheet.gain().isPresent() && sheet.integrationTime().isPresent()) {
            checks.put("beams", () -> beams(radar, sheet));
        }
    }

    /**
     * The area of the antenna that a search takes, whatever its gain and its beams: {@code A = 4 pi k T0 F L S Omega
     * r^4 / (P sigma t)} with all of the power all of the time (Barton, Radar System Analysis and Modeling, section
     * 1.3), F = 5 dB and L = 6 dB as this library assumes. No compact radar has more than a quarter of a square metre;
     * a gain that is stated must not belong to a smaller area.
     */
    private static void aperture(CatalogEntry entry, RadarSettings radar, double power) {
        double solid = radar.azimuthWidth() * 2.0 * Math.sin(0.5 * radar.elevationWidth());
        for (PublishedRange range : entry.ranges()) {
            double section = stated(range.target(), "([\\d.]+) m2")
                    .map(one -> number(one, 1))
                    .orElseThrow();
            double area = 4.0
                    * Math.PI
                    * 1.380649e-23
                    * 290.0
                    * Math.pow(10.0, 0.1 * (5.0 + 6.0 + 13.1835))
                    * solid
                    * Math.pow(range.distance(), 4)
                    * radar.rate()
                    / (power * section);
            assertThat(area).as("antenna of %f m2", area).isLessThan(0.25);
            double wavelength = LIGHT / radar.frequency();
            ((DataSheet) radar.budget()).gain().ifPresent(gain -> assertThat(
                            Math.pow(10.0, 0.1 * gain) * wavelength * wavelength / (4.0 * Math.PI))
                    .isGreaterThan(0.99 * area));
        }
    }

    /** Each beam covers {@code 4 pi / G} at most, and takes the integration time. */
    private static void beams(RadarSettings radar, DataSheet sheet) {
        double solid = radar.azimuthWidth() * 2.0 * Math.sin(0.5 * radar.elevationWidth());
        double beams = solid * Math.pow(10.0, 0.1 * sheet.gain().orElseThrow()) / (4.0 * Math.PI);
        assertThat(beams * sheet.integrationTime().orElseThrow() * radar.rate()).isLessThanOrEqualTo(1.0);
        assertThat(radar.withRate(1.05 * radar.rate()).advice()).isNotEmpty();
        assertThat(radar.advice()).isEmpty();
    }

    private static void camera(String name, CatalogEntry entry, PictureSettings camera, Map<String, Runnable> checks) {
        MatchResult view = stated(entry.coverage(), "([\\d.]+) x ([\\d.]+) deg").orElseThrow();
        double across = Math.toDegrees(2.0 * Math.atan(0.5 * camera.width() / camera.focalLength()));
        double upright = Math.toDegrees(2.0 * Math.atan(0.5 * camera.height() / camera.focalLength()));
        checks.put("field of view", () -> {
            assertThat(across).isCloseTo(number(view, 1), within(0.02 * across));
            assertThat(upright).isCloseTo(number(view, 2), within(0.02 * upright));
        });
        stated(entry.source(), "(\\d+) x (\\d+),")
                .ifPresent(image -> checks.put("pixels", () -> {
                    assertThat(camera.width()).isEqualTo((int) number(image, 1));
                    assertThat(camera.height()).isEqualTo((int) number(image, 2));
                }));
        stated(entry.source(), "([\\d.]+) megapixels")
                .ifPresent(image -> checks.put("pixels", () -> assertThat(1e-6 * camera.width() * camera.height())
                        .isCloseTo(number(image, 1), within(0.05))));
        stated(entry.source(), "field of view ([\\d.]+) to ([\\d.]+) deg")
                .ifPresent(zoom -> checks.put("zoom", () -> assertThat(Math.toDegrees(camera.fov()))
                        .isCloseTo(number(zoom, name.endsWith("-tele") ? 2 : 1), within(1e-9))));
        stated(entry.source(), "optical zoom x(\\d+)")
                .ifPresent(zoom -> checks.put("zoom", () -> {
                    double wide = focalLength(name.replace("-tele", ""));
                    double tele = focalLength(name.replace("-tele", "") + "-tele");
                    assertThat(tele / wide).isCloseTo(number(zoom, 1), within(0.01 * number(zoom, 1)));
                }));
        stated(entry.source(), "([\\d.]+) to ([\\d.]+) um")
                .ifPresent(band -> checks.put("band", () -> assertThat(1e6 * camera.wavelength())
                        .isBetween(number(band, 1), number(band, 2))));
        // The same number of pixels on both drones: the larger one is larger by the ratio of the ranges.
        if (entry.ranges().size() == 2) {
            checks.put("ratio of ranges", () -> {
                double ratio =
                        entry.ranges().get(1).distance() / entry.ranges().get(0).distance();
                assertThat(stated(entry.ranges().get(1).target(), "([\\d.]+) times")
                                .map(one -> number(one, 1))
                                .orElseThrow())
                        .isCloseTo(ratio, within(0.01));
            });
        }
    }

    private static double focalLength(String name) {
        PictureSettings camera =
                (PictureSettings) Catalog.packaged().settings(name, Map.of("position", new Position(0, 0, 10)));
        assertThat(camera.fovAxis()).isEqualTo(FieldOfView.HORIZONTAL);
        return camera.focalLength();
    }

    /** Free space by hand: {@code 20 lg(4 pi r f / c) = P + G - (10 lg(k T0 B) + F + S)}. */
    private static void receiver(CatalogEntry entry, RfSettings receiver, Map<String, Runnable> checks) {
        MatchResult target = stated(entry.ranges().get(0).target(), "(\\d+) dBm at ([\\d.]+) GHz")
                .orElseThrow();
        double frequency = 1e9 * number(target, 2);
        checks.put("band", () -> assertThat(frequency).isBetween(receiver.minFrequency(), receiver.maxFrequency()));
        checks.put("link budget", () -> {
            double floor = 10.0 * Math.log10(1.380649e-23 * 290.0 * receiver.bandwidth() * 1000.0);
            double loss = number(target, 1) + receiver.gain() - floor - receiver.noiseFigure() - receiver.threshold();
            double free = Math.pow(10.0, loss / 20.0) * LIGHT / (4.0 * Math.PI * frequency);
            MatchResult note = stated(entry.note(), "free space the range would be ([\\d.]+) km")
                    .orElseThrow();
            assertThat(1e-3 * free).isCloseTo(number(note, 1), within(0.01));
            assertThat(20.0 * Math.log10(free / entry.ranges().get(0).distance()))
                    .isCloseTo(receiver.clutter(), within(0.05));
        });
    }

    /** Against incoherent noise n microphones gain 10 lg n. */
    private static void microphones(CatalogEntry entry, AcousticSettings acoustic, Map<String, Runnable> checks) {
        checks.put("number of microphones", () -> {
            double count = acoustic.array()
                    .map(array -> (double) array.microphones())
                    .orElseGet(() -> number(
                            stated(entry.note(), "of (\\d+) microphones against")
                                    .orElseThrow(),
                            1));
            double gain = acoustic.array().isPresent()
                    ? number(stated(entry.note(), "noise, (\\d+) dB").orElseThrow(), 1)
                    : acoustic.arrayGain();
            assertThat(10.0 * Math.log10(count)).isCloseTo(gain, within(0.1));
        });
        stated(entry.title(), "(\\d+) microphones, ([\\d.]+) m")
                .ifPresent(size -> checks.put("size", () -> {
                    assertThat(acoustic.array().orElseThrow().microphones()).isEqualTo((int) number(size, 1));
                    assertThat(acoustic.array().orElseThrow().aperture()).isEqualTo(number(size, 2));
                }));
        stated(entry.source(), "quadrotors at (\\d+) to (\\d+) m")
                .ifPresent(span -> checks.put("midpoint of the published range", () -> assertThat(
                                entry.ranges().get(0).distance())
                        .isEqualTo(0.5 * (number(span, 1) + number(span, 2)))));
        // Spherical spreading alone would double the range for 6 dB less background; air and ground take the rest.
        if (entry.ranges().size() == 2) {
            checks.put("ratio of ranges", () -> {
                double less = background(entry, 0) - background(entry, 1);
                double ratio =
                        entry.ranges().get(1).distance() / entry.ranges().get(0).distance();
                assertThat(20.0 * Math.log10(ratio)).isBetween(0.5 * less, less);
            });
        }
    }

    private static double background(CatalogEntry entry, int range) {
        return number(stated(entry.ranges().get(range).target(), "in (\\d+) dB").orElseThrow(), 1);
    }
}
