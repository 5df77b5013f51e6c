package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import com.networknt.schema.InputFormat;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.placement.plan.PlaceSettings;
import org.dronewatch.scenario.SceneSchema;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The schema of scene files and the page of all settings are those of the records, and the drawing of the packages is
 * that of the build's rules. When one of them has changed, write them again: {@code mvn test -Dtest=GeneratedDocsTest
 * -Ddronewatch.docs=write}.
 */
class GeneratedDocsTest {
    private static final Path SCHEMA = Path.of("scenes/scene.schema.json");
    private static final Path PLACE_SCHEMA = Path.of("scenes/place.schema.json");
    private static final Path TEXTS = Path.of("src/main/resources/org/dronewatch/scenario/texts.json");
    private static final Path REFERENCE = Path.of("src/site/markdown/settings.md");
    private static final Path HOUSE = Path.of("src/site/images/packages.svg");
    private static RecordTexts texts;

    @BeforeAll
    static void readTheSources() throws IOException {
        texts = RecordTexts.of(Path.of("src/main/java"));
    }

    private static void assertUpToDate(Path file, String content) throws IOException {
        if ("write".equals(System.getProperty("dronewatch.docs"))) {
            Files.createDirectories(file.toAbsolutePath().getParent());
            Files.writeString(file, content);
        }
        assertThat(Files.readString(file))
                .as("%s; write it again with -Ddronewatch.docs=write", file)
                .isEqualTo(content);
    }

    @Test
    void theSchemaIsThatOfTheRecords() throws IOException {
        assertUpToDate(SCHEMA, new SceneSchema(texts).write());
        assertUpToDate(PLACE_SCHEMA, new SceneSchema(texts).write("dronewatch placement", PlaceSettings.class));
    }

    @Test
    void theSchemaOfPlacementsAcceptsTheExampleAndRefusesWhatIsWrong() throws IOException {
        Schema schema = SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
                .getSchema(Files.readString(PLACE_SCHEMA), InputFormat.JSON);
        String example = Files.readString(Path.of("scenes", "palace.place.yaml"));

        assertThat(schema.validate(example, InputFormat.YAML)).isEmpty();
        assertThat(schema.validate(example.replace("aims: 4", "atMost: 2"), InputFormat.YAML))
                .isEmpty();
        assertThat(schema.validate(example.replace("budget", "bugdet"), InputFormat.YAML))
                .isNotEmpty();
        assertThat(schema.validate(example.replace("price: 20000", "price: -1"), InputFormat.YAML))
                .isNotEmpty();
    }

    @Test
    void theTextsInTheJarAreThoseOfTheSources() throws IOException {
        CollectedTexts collected = new CollectedTexts(texts);
        new SceneSchema(collected).write();
        new SceneSchema(collected).write("dronewatch placement", PlaceSettings.class);
        assertUpToDate(TEXTS, collected.write());
    }

    @Test
    void thePageOfAllSettingsIsThatOfTheRecords() throws IOException {
        assertUpToDate(REFERENCE, new SettingsReference(texts).write());
    }

    @Test
    void theDrawingOfTheHouseIsThatOfItsRules() throws IOException {
        assertUpToDate(HOUSE, HouseDrawing.write());
    }

    private static Schema schema() throws IOException {
        return SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
                .getSchema(Files.readString(SCHEMA), InputFormat.JSON);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "closed-space",
                "camera-range",
                "acoustic-range",
                "multi-sensor",
                "hill-radar",
                "glider",
                "cued-camera"
            })
    void itAcceptsTheScenes(String name) throws IOException {
        String scene = Files.readString(Path.of("scenes", name + ".yaml"));
        assertThat(schema().validate(scene, InputFormat.YAML)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "world: {models: [a.obj], surfaces: {otherwise: solid}}",
                "world: {models: [a.obj]}\n"
                        + "drones: {a: {model: b.obj, flight: {kind: pop-up, position: [0, 0, 1], hidden: 3, height: 4}}}",
            })
    void itAcceptsFormerNamesAndMarksThem(String scene) throws IOException {
        assertThat(schema().validate(scene, InputFormat.YAML)).isEmpty();
        assertThat(Files.readString(SCHEMA)).contains("\"deprecated\" : true");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "world: {models: [a.obj], surfaces: {otherwise: solid, defaultSurface: solid}}",
                "world: {models: [a.obj]}\n"
                        + "drones: {a: {model: b.obj, flight: {kind: pop-up, position: [0, 0, 1], height: 4}}}",
                "world: {modles: [a.obj]}",
                "{}",
                "world: {models: [a.obj], backgroundNoise: 500}",
                "world: {models: [a.obj]}\nrun: {duration: 0}",
                "world: {models: [a.obj]}\nsensors: {a: {kind: camera}}",
                "world: {models: [a.obj]}\nsensors: {a: {kind: camera, position: [1, 2]}}",
                "world: {models: [a.obj]}\nsensors: {a: {kind: camera, position: [1, 2, 3], width: many, wdith: 1}}",
                "world: {models: [a.obj]}\ndrones: {a: {model: a.obj, flight: {kind: hoover}}}",
            })
    void itRefusesWhatIsWrong(String scene) throws IOException {
        assertThat(schema().validate(scene, InputFormat.YAML)).isNotEmpty();
    }
}
