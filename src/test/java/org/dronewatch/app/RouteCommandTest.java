package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The weakest routes before a radar and a receiver, as the command prints and writes them. */
class RouteCommandTest {
    private static final String SENSORS = FieldSite.ROUND
            + "  radio: {kind: rf, position: [0, 5, 4], threshold: 45}\n"
            + "alert: {protect: {centre: [0, 0, 10], radius: 30}, response: 5 s}\n";

    @TempDir
    private static Path directory;

    private static Outcome outcome;
    private static JsonNode json;

    @BeforeAll
    static void run() throws IOException {
        FieldSite.in(directory, SENSORS);
        Path site = directory.resolve("site.yaml");
        String origin = "world:\n  origin: {latitude: 50 deg, longitude: 8 deg}\n";
        Files.writeString(site, Files.readString(site).replaceFirst("world:\n", origin));
        outcome = route("1", ".");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        json = read("route.json");
    }

    private static JsonNode read(String file) {
        return JsonMapper.builder().build().readTree(directory.resolve(file).toFile());
    }

    private static Outcome route(String threads, String out, String... more) {
        return Program.run(Stream.concat(
                        Stream.of(
                                "route",
                                directory.resolve("site.yaml").toString(),
                                "--heights=10",
                                "--side=400",
                                "--cell=40m",
                                "--stopped=0.5",
                                "--threads=" + threads,
                                "--out=" + directory.resolve(out)),
                        Stream.of(more))
                .toArray(String[]::new));
    }

    @Test
    void theFileStatesWhatWasAskedAndWhatWasFound() {
        assertThat(json.propertyNames())
                .containsExactly(
                        "format",
                        "scene",
                        "drone",
                        "pointing",
                        "modes",
                        "launch",
                        "response_s",
                        "p_n",
                        "cell_m",
                        "cells_per_side",
                        "heights_m",
                        "between_cells",
                        "starts_s",
                        "origin",
                        "least_exposure",
                        "routes",
                        "notes",
                        "warnings",
                        "complete");
        assertThat(json.get("complete").asBoolean()).isTrue();
        assertThat(json.get("response_s").asDouble()).isEqualTo(5.0);
        assertThat(json.get("pointing").asString()).isEqualTo("search");
        assertThat(json.get("routes")).hasSize(8);
        JsonNode first = json.get("routes").get(0);
        assertThat(first.get("sector").asString()).isEqualTo("north");
        assertThat(first.propertyNames())
                .containsExactly(
                        "sector",
                        "points",
                        "exposure",
                        "lower",
                        "upper",
                        "p_detect",
                        "by_sensor",
                        "causes_s",
                        "causes_by_sensor_s",
                        "p_in_time",
                        "critical_s",
                        "p_i",
                        "p_e",
                        "proof");
        assertThat(first.get("points").get(0).propertyNames()).containsExactly("t", "x", "y", "z", "mode");
        for (JsonNode route : json.get("routes")) {
            double exposure = route.get("exposure").asDouble();
            assertThat(route.get("lower").asDouble())
                    .isLessThanOrEqualTo(route.get("upper").asDouble());
            assertThat(route.get("upper").asDouble()).isLessThanOrEqualTo(exposure + 1e-6);
            assertThat(route.get("by_sensor").propertyNames()).containsExactly("round", "radio");
            double sum = route.get("by_sensor").get("round").asDouble()
                    + route.get("by_sensor").get("radio").asDouble();
            assertThat(route.get("p_detect").asDouble()).isCloseTo(1.0 - Math.exp(-sum), within(1e-5));
            assertThat(route.get("p_i").asDouble())
                    .isBetween(0.0, route.get("p_detect").asDouble() + 1e-5);
            assertThat(route.get("causes_by_sensor_s").propertyNames()).containsExactly("round", "radio");
            JsonNode last = route.get("points").get(route.get("points").size() - 1);
            assertThat(route.get("critical_s").asDouble())
                    .isCloseTo(last.get("t").asDouble() - 5.0, within(1e-5));
            for (JsonNode times : List.of(
                    route.get("causes_s"),
                    route.get("causes_by_sensor_s").get("round"),
                    route.get("causes_by_sensor_s").get("radio"))) {
                double seconds = 0.0;
                for (JsonNode one : times) {
                    seconds += one.asDouble();
                }
                assertThat(seconds).isCloseTo(last.get("t").asDouble(), within(1e-3));
            }
            assertThat(Math.hypot(last.get("x").asDouble(), last.get("y").asDouble()))
                    .isLessThanOrEqualTo(30.0);
        }
    }

    @Test
    void theTableHasARowForEachSectorAndTheWeakestInWords() {
        List<String> lines = outcome.out().lines().toList();
        assertThat(lines.get(0))
                .isEqualTo("weakest routes of drone 'one' to the protected zone, by starting direction;"
                        + " exposure counts while at least 5 s are left for the response:");
        assertThat(lines.subList(2, 10))
                .extracting(line -> line.substring(0, 11).strip())
                .containsExactly(
                        "north", "north-east", "east", "south-east", "south", "south-west", "west", "north-west");
        assertThat(lines.get(11))
                .startsWith("On the weakest route, the drone comes from the ")
                .endsWith(".");
    }

    /** The drone of a route's scene is where the file states, when it states it, and ends in the zone. */
    @Test
    void aSceneFliesItsRoute() throws IOException {
        SceneRunner runner = new SceneRunner(new SceneFile(directory.resolve("route-south-west.yaml")));
        SceneSettings scene = runner.settings();
        FlightPath flight = runner.stage(scene).flight("one");
        JsonNode points = json.get("routes").get(5).get("points");
        double end = points.get(points.size() - 1).get("t").asDouble();
        assertThat(scene.run().duration()).isCloseTo(end, within(1e-5));
        for (JsonNode point : points) {
            Position at = flight.at(point.get("t").asDouble()).position();
            assertThat(at.x()).isCloseTo(point.get("x").asDouble(), within(1e-3));
            assertThat(at.y()).isCloseTo(point.get("y").asDouble(), within(1e-3));
            assertThat(at.z()).isCloseTo(point.get("z").asDouble(), within(1e-3));
        }
    }

    /** On any number of threads, the radar and the receiver, which know no chance, detect it always or never. */
    @Test
    void aProofIsPrinted() {
        Outcome proved = Program.run(
                "route",
                directory.resolve("site.yaml").toString(),
                "--heights=10",
                "--side=400",
                "--cell=40m",
                "--threads=3",
                "--stopped=0.5",
                "--proof=20");
        assertThat(proved.code()).as(proved.err()).isZero();
        List<String> lines = proved.out().lines().toList();
        assertThat(lines.subList(0, 10))
                .isEqualTo(outcome.out().lines().toList().subList(0, 10));
        int table = lines.indexOf("flown with many seeds:");
        assertThat(lines.subList(table + 2, table + 10)).allMatch(line -> line.matches("[a-z-]+ +(0|20) of 20 .* yes"));
    }

    /** The pieces of each route follow one another from its start to its end. */
    @Test
    void mapsHaveTheRoutesInPieces() throws IOException {
        assertThat(directory.resolve("routes.kml")).content().contains("<Folder>", "from the south-west");
        JsonNode features = read("routes.geojson").get("features");
        String route = "";
        JsonNode before = null;
        int routes = 0;
        for (JsonNode feature : features) {
            JsonNode properties = feature.get("properties");
            JsonNode line = feature.get("geometry").get("coordinates");
            assertThat(line.size()).isGreaterThanOrEqualTo(2);
            if (properties.get("folder").asString().equals(route)) {
                assertThat(line.get(0)).isEqualTo(before);
            } else {
                assertThat(properties.get("begin_s").asDouble()).isZero();
                routes++;
            }
            route = properties.get("folder").asString();
            before = line.get(line.size() - 1);
        }
        assertThat(routes).isEqualTo(8);
    }

    /** A scene that an earlier search has written, searched again where it is. */
    @Test
    void theSceneIsNotReplacedByARoute() throws IOException {
        Path scene = directory.resolve("route-north.yaml");
        String before = Files.readString(scene);
        Outcome refused = Program.run("route", scene.toString(), "--heights=10", "--out=" + directory);

        assertThat(refused.code()).isEqualTo(2);
        assertThat(refused.complaints())
                .containsExactly("output directory " + directory + " holds an input of the command (route-north.yaml),"
                        + " which would be replaced: choose another directory");
        assertThat(scene).hasContent(before);
    }
}
