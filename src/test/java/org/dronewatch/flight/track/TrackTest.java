package org.dronewatch.flight.track;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightState;
import org.dronewatch.flight.file.DamagedFiles;
import org.dronewatch.flight.file.DroneSpeeds;
import org.dronewatch.flight.file.EquatorSite;
import org.dronewatch.flight.file.FlightSource;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.InputException;
import org.dronewatch.world.Ground;
import org.dronewatch.world.Places;
import org.dronewatch.world.WorldSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TrackTest {
    private static final DroneSpeeds DRONE = new DroneSpeeds(5.0, 2.5, 3.0, 1.5);

    private static final String GPX =
            """
            <?xml version="1.0" encoding="UTF-8"?>
            <gpx version="1.1" creator="a logger" xmlns="http://www.topografix.com/GPX/1/1">
              <metadata><name>flights</name><time>2026-11-24T03:00:00Z</time></metadata>
              <trk><name>first</name><trkseg>
                <trkpt lat="1.0" lon="2.0"><ele>120.0</ele><time>2026-11-24T03:00:10Z</time></trkpt>
                <trkpt lat="1.001" lon="2.0"><ele>130.0</ele><time>2026-11-24T03:00:20.500Z</time><extensions><ele>7</ele></extensions></trkpt>
                <trkpt lat="1.001" lon="2.0"><ele>131.0</ele><time>2026-11-24T03:00:20.500Z</time></trkpt>
              </trkseg><trkseg>
                <trkpt lat="1.001" lon="2.001"><ele>130.0</ele><time>2026-11-24T04:00:30.5+01:00</time></trkpt>
              </trkseg></trk>
            </gpx>
            """;

    private static final String DJI =
            """
            time(millisecond),datetime(utc),latitude,longitude,height_above_takeoff(feet),altitude_above_seaLevel(feet),speed(mph)
            100,2026-11-24 03:00:00,1.0,2.0,0,500,1
            10100,2026-11-24 03:00:10,1.001,2.0,100,600,1
            """;

    @TempDir
    private Path directory;

    private final List<String> warnings = new ArrayList<>();
    private Ground ground = (x, y) -> OptionalDouble.of(0.25 * y);

    private FlightSource read(Track settings, String text) throws IOException {
        Path file = Files.writeString(directory.resolve("log"), text);
        return settings.read(file, settings.log());
    }

    private FlightPath fly(Track settings, String text) throws IOException {
        Places places = new Places(WorldSettings.EMPTY.withOrigin(EquatorSite.ORIGIN), () -> ground);
        return read(settings, text).path(places, DRONE, warnings::add);
    }

    private static Track track(String log, Track.Heights heights, double offset) {
        return new Track(log, heights, offset, Optional.empty());
    }

    private static void assertAt(FlightState state, Position place) {
        assertThat(state.position().distance(place))
                .as("%s, not %s", state.position(), place)
                .isLessThan(1e-6);
    }

    @Test
    void aTrackIsFlownAtItsTimes() throws IOException {
        FlightPath path = fly(Track.of("a.gpx"), GPX);
        Position first = EquatorSite.at(1.0, 2.0, 120);
        Position second = EquatorSite.at(1.001, 2.0, 130);
        Position third = EquatorSite.at(1.001, 2.001, 130);
        assertAt(path.at(0.0), first);
        assertAt(path.at(5.25), first.plus(second).times(0.5));
        assertAt(path.at(10.5), second);
        assertThat(path.at(3.0).velocity().distance(second.minus(first).times(1 / 10.5)))
                .isLessThan(1e-9);
        assertThat(path.at(3.0).heading()).isEqualTo(0.0, within(1e-3));
        assertAt(path.at(20.5), third);
        assertThat(path.at(15.0).heading()).isEqualTo(Math.PI / 2, within(1e-3));
        assertAt(path.at(100.0), third);
        assertThat(path.at(100.0).velocity().length()).isZero();
        assertThat(read(Track.of("a.gpx"), GPX).description())
                .isEqualTo("a.gpx: 3 points in 20.5 s; 2 segments of the track are joined by straight lines;"
                        + " 1 point has the same time as the one before, and is left out");
    }

    @Test
    void heightsCountFromTheSeaTheStartOrTheSurface() throws IOException {
        assertAt(fly(track("a.gpx", Track.Heights.SEA, -20), GPX).at(10.5), EquatorSite.at(1.001, 2.0, 110));
        assertAt(fly(track("a.gpx", Track.Heights.START, 0), GPX).at(10.5), EquatorSite.at(1.001, 2.0, 110));
        FlightPath over = fly(track("a.gpx", Track.Heights.SURFACE, -100), GPX);
        Position second = over.at(10.5).position();
        assertThat(second.z() - 0.25 * second.y()).isEqualTo(30.0, within(1e-3));
        String flat = GPX.replaceAll("<ele>1.*?</ele>", "");
        Position low =
                fly(track("a.gpx", Track.Heights.SURFACE, 60), flat).at(10.5).position();
        assertThat(low.z() - 0.25 * low.y()).isEqualTo(60.0, within(1e-3));
        assertThatThrownBy(() -> fly(Track.of("a.gpx"), flat))
                .isInstanceOf(InputException.class)
                .hasMessageStartingWith("a.gpx:5: has no height: with 'heights: surface'");
        ground = (x, y) -> y > 50 ? OptionalDouble.empty() : OptionalDouble.of(0);
        assertThatThrownBy(() -> fly(track("a.gpx", Track.Heights.SURFACE, 0), GPX))
                .hasMessageContaining("a.gpx:6: no surface at latitude 1.001000 deg, longitude 2.000000 deg");
    }

    @Test
    void withoutTimesItsPointsAreWaypoints() throws IOException {
        String route = GPX.replaceAll("<time>.*?</time>", "")
                .replace("trkpt", "rtept")
                .replaceAll("</?trkseg>", "")
                .replace("trk>", "rte>");
        FlightPath path = fly(Track.of("a.gpx"), route);
        assertThat(path.at(10.0).velocity().length()).isEqualTo(5.0, within(1e-9));
        assertAt(path.at(1000.0), EquatorSite.at(1.001, 2.001, 130));
        assertThat(warnings)
                .containsExactly("a.gpx: has no times: the drone flies through its points at its own speed");
    }

    @Test
    void oneOfSeveralTracksIsChosenByName() throws IOException {
        String two = GPX.replace(
                "</gpx>",
                "<trk><name>second</name><trkseg><trkpt lat=\"1\" lon=\"2.002\"><ele>99</ele>"
                        + "<time>2026-11-24T03:00:00</time></trkpt></trkseg></trk></gpx>");
        assertThatThrownBy(() -> read(Track.of("a.gpx"), two))
                .hasMessage("a.gpx: has 2 tracks: give 'track', one of first, second");
        Track second = new Track("a.gpx", Track.Heights.SEA, 0, Optional.of("second"));
        assertAt(fly(second, two).at(5.0), EquatorSite.at(1.0, 2.002, 99));
        assertThatThrownBy(() -> read(second, GPX)).hasMessageContaining("has no track 'second'; ");
    }

    /** As a well-known maker's drones are exported: feet and milliseconds. */
    @Test
    void columnsAreKnownByNameAndUnit() throws IOException {
        assertAt(fly(Track.of("a.csv"), DJI).at(10.0), EquatorSite.at(1.001, 2.0, 600 * 0.3048));
        ground = (x, y) -> OptionalDouble.of(12.0);
        assertAt(fly(track("a.csv", Track.Heights.START, 0), DJI).at(10.0), EquatorSite.at(1.001, 2.0, 112.0 + 30.48));
        assertThat(read(Track.of("a.csv"), DJI).description())
                .isEqualTo("a.csv: 2 points in 10.0 s; columns 'time(millisecond)', 'latitude', 'longitude',"
                        + " 'altitude_above_seaLevel(feet)'");
        assertThat(read(track("a.csv", Track.Heights.SURFACE, 0), DJI).description())
                .endsWith("columns 'time(millisecond)', 'latitude', 'longitude';"
                        + " there is no column of heights, so all heights are 0");
        assertAt(
                fly(track("a.csv", Track.Heights.SURFACE, 0), "time,lat,lon,alt\n0,1.0,2.0,30\n")
                        .at(0.0),
                EquatorSite.at(1.0, 2.0, 142.0));
        String plain =
                "\uFEFFTimestamp;Lat;Lon;Alt [m]\n2026-11-24T03:00:00Z;1.0;2.0;150\n2026-11-24T03:00:04Z;1.001;2.0;150\n";
        assertAt(fly(Track.of("b.csv"), plain).at(4.0), EquatorSite.at(1.001, 2.0, 150));
        String seconds = "time_s,lat,lng,altitude_m\n1e3,1.0,2.0,150\n1004,1.001,2.0,150\n";
        assertAt(fly(Track.of("b.csv"), seconds).at(4.0), EquatorSite.at(1.001, 2.0, 150));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<gpx version= | <kml version= | a.gpx:2: begins with <kml> but must begin with <gpx>",
                "lat=\"1.0\" | lat=\"95\" | a.gpx:5: lat 95 must be -90.0 to 90.0",
                "lat=\"1.0\" | lat=\"x\" | a.gpx:5: lat 'x' must be a number",
                "lat=\"1.0\" | la=\"1\" | a.gpx:5: lat 'null' must be a number",
                "<ele>120.0</ele> | <ele>NaN</ele> | a.gpx:5: ele NaN must be -100000.0 to 100000.0",
                "03:00:10Z | 03:00:60Z | a.gpx:5: time '2026-11-24T03:00:60Z' must be written as in",
                "03:00:10Z | 03:59:10Z | a.gpx:6: is 3529.5 s before the point on line 5: times must increase",
                "<time>2026-11-24T03:00:10Z</time> | '' | a.gpx:6: has a time, but points before it have none",
                "</trk> | '' | a.gpx:11: not well-formed XML",
                "trkpt | point | a.gpx: has no track with points",
                "<gpx | <!DOCTYPE gpx [<!ENTITY a \"b\">]><gpx | a.gpx:2: has a document type",
            })
    void whatIsWrongIsRefusedInALine(String old, String wrong, String message) {
        assertRefused("a.gpx", GPX, old, wrong, message);
    }

    private void assertRefused(String file, String text, String old, String wrong, String message) {
        assertThat(text).contains(old);
        assertThatThrownBy(() -> read(Track.of(file), text.replace(old, wrong)))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(message)
                .satisfies(e -> assertThat(e.getMessage().lines()).hasSize(1));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "latitude | breadth | a.csv:1: no column for the latitude: none of latitude, lat among time(millisecond)",
                "altitude_above_seaLevel(feet) | altitude_barrels | a.csv:1: no column for the height",
                "1.001 | x | a.csv:3: latitude 'x' must be a number",
                "1.001 | 437314000 | a.csv:3: latitude 437314000 must be -90.0 to 90.0",
                "10100, | 50, | a.csv:3: is 0.05 s before the point on line 2: times must increase",
                "1.001,2.0,100,600,1 | 1.001 | a.csv:3: has 3 values, none for longitude",
                "100,2026-11-24 03:00:00,1.0,2.0,0,500,1 | \"100,2026 | a.csv:2: has 1 value, none for latitude",
            })
    void whatIsWrongInALogIsRefusedInALine(String old, String wrong, String message) {
        assertRefused("a.csv", DJI, old, wrong, message);
    }

    @Test
    void jumpsAndEmptyFilesAreRefused() throws IOException {
        assertThatThrownBy(() -> fly(Track.of("a.csv"), DJI.replace("1.001", "1.1")))
                .hasMessageContaining("a.csv:3: is reached at 1106 m/s from line 2, but at most 400 m/s is possible");
        assertThatThrownBy(() -> fly(Track.of("a.csv"), DJI.replace("1.001", "7.1")))
                .hasMessageContaining("a.csv:3: latitude 7.100000 deg, longitude 2.000000 deg lies");
        assertThatThrownBy(() -> read(Track.of("a.csv"), "")).isInstanceOf(InputException.class);
        assertThatThrownBy(() -> read(Track.of("a.csv"), "time,lat,lon,alt\n"))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("has no points");
        assertThatThrownBy(() -> read(new Track("a.csv", Track.Heights.SEA, 0, Optional.of("x")), DJI))
                .hasMessageContaining("leave 'track' out");
    }

    @Test
    void damagedFilesAreReadOrRefused() {
        Places places = new Places(WorldSettings.EMPTY.withOrigin(EquatorSite.ORIGIN), () -> ground);
        Track settings = Track.of("a");
        int refused = DamagedFiles.refused(
                GPX, bytes -> new TrackedFlight(settings, GpxFile.read("a", bytes, Optional.empty()), bytes)
                        .path(places, DRONE, line -> {}));
        assertThat(refused).isBetween(150, 590);
        refused = DamagedFiles.refused(DJI, bytes -> new TrackedFlight(
                        settings, CsvLog.read("a", bytes, Track.Heights.SEA, Optional.empty()), bytes)
                .path(places, DRONE, line -> {}));
        assertThat(refused).isBetween(150, 590);
    }

    /** What expands without end, or is nested without end, is refused at once. */
    @Test
    void hostileFilesAreRefused() {
        String laughs = "<!DOCTYPE gpx [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;\">]>";
        assertThatThrownBy(() -> read(Track.of("a.gpx"), laughs + "<gpx><trk><name>&b;</name></trk></gpx>"))
                .hasMessageContaining("has a document type");
        assertThatThrownBy(() -> read(Track.of("a.gpx"), "<gpx>" + "<a>".repeat(100_000)))
                .hasMessageContaining("nested more than 64 deep");
        assertThatThrownBy(() ->
                        read(Track.of("a.gpx"), "<gpx><trk><trkseg><trkpt lat='1' lon='2'>" + "<a>".repeat(100_000)))
                .hasMessageContaining("nested more than 64 deep");
    }
}
