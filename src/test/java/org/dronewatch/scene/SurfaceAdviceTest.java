package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a scene says about surfaces and materials that do not fit together. */
class SurfaceAdviceTest {
    private static final String REST =
            """
            drones:
              drone:
                model: packaged:quadrotor.obj
                flight: {kind: hover, position: [5, 0, 3]}
            sensors:
              microphone: {kind: acoustic, position: [0, 0, 1]}
            run: {duration: 0.1 s}
            """;

    @TempDir
    private Path directory;

    private List<String> warnings(String surfaces) throws IOException {
        Files.writeString(
                directory.resolve("yard.obj"),
                """
                usemtl lawn
                v -50 -50 0
                v 50 -50 0
                v 50 50 0
                v -50 50 0
                f 1 2 3
                usemtl brick_rough:painted
                f 1 3 4
                """);
        Path file = directory.resolve("site.yaml");
        Files.writeString(file, "world: {models: [{file: yard.obj, upAxis: z}], surfaces: " + surfaces + "}\n" + REST);
        List<String> notes = new ArrayList<>();
        new SceneRunner(new SceneFile(file)).notes(notes::add).run();
        return notes.stream().filter(note -> note.startsWith("warning")).toList();
    }

    @Test
    void whatFitsNeedsNoAdvice() throws IOException {
        assertThat(warnings("{materials: {lawn: grass_turf}}")).isEmpty();
        assertThat(warnings("{materials: {lawn: grass_turf, brick_rough: concrete_rough}}"))
                .as("a material with a variant")
                .isEmpty();
        assertThat(warnings("{materials: {lawn: grass_turf, 'brick_rough:painted': concrete_rough}}"))
                .as("the variant itself")
                .isEmpty();
    }

    @Test
    void aMaterialWithoutASurfaceIsNamed() throws IOException {
        assertThat(warnings("{}"))
                .containsExactly("warning: no acoustic surface is assigned to lawn: treated as 'solid';"
                        + " world.surfaces.materials can assign other surfaces");
    }

    @Test
    void aSurfaceForAMaterialThatNoModelHasIsNamed() throws IOException {
        assertThat(warnings("{materials: {lawn: grass_turf, roof: brick_rough, Lawn: grass_turf}}"))
                .containsExactly(
                        "warning: world.surfaces.materials: the models have no material named roof or Lawn; they"
                                + " have lawn, brick_rough:painted");
    }

    @Test
    void anOwnSurfaceThatNothingUsesIsNamed() throws IOException {
        assertThat(warnings("{materials: {lawn: grass_turf}, own: {felt: {absorption: 0.5}}}"))
                .containsExactly("warning: world.surfaces.own.felt has no effect: no material of the models uses this"
                        + " surface; the materials are lawn, brick_rough:painted");
    }
}
