package org.dronewatch.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.dronewatch.geometry.TriangleMesh;
import org.junit.jupiter.api.Test;

class WorldMergeTest {
    private static final int MATERIALS = 40_000;
    private static final int TRIANGLES = 400_000;

    /** Triangles of one shape whose materials take turns. */
    private static TriangleMesh mesh(int triangles, List<String> materials) {
        int[] numbers = IntStream.range(0, triangles).toArray();
        int[] turns =
                IntStream.range(0, triangles).map(i -> i % materials.size()).toArray();
        int[] corners = IntStream.range(0, 3 * triangles).map(i -> i % 3).toArray();
        return new TriangleMesh(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, corners, turns, numbers, materials);
    }

    private static List<String> names(int first) {
        return IntStream.range(first, first + MATERIALS).mapToObj(i -> "m" + i).toList();
    }

    @Test
    void materialsAreNumberedByTheirFirstUseAndSharedByName() {
        TriangleMesh merged =
                World.merge(List.of(mesh(2, List.of("b", "a", "unused")), mesh(3, List.of("c", "a", "d"))));

        assertThat(merged.materialNames()).containsExactly("b", "a", "c", "d");
        assertThat(IntStream.range(0, 5).map(merged::material)).containsExactly(0, 1, 2, 1, 3);
        assertThat(IntStream.range(0, 5).map(merged::sourceNumber)).containsExactly(0, 1, 2, 3, 4);
    }

    @Test
    void tensOfThousandsOfMaterialsOfSeveralModelsAreMergedInLinearTime() {
        List<TriangleMesh> meshes = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            meshes.add(mesh(TRIANGLES, names(i * MATERIALS / 2)));
        }

        // Two million look-ups take about a second; comparing names one by one takes many minutes.
        TriangleMesh merged = assertTimeoutPreemptively(Duration.ofMinutes(1), () -> World.merge(meshes));

        assertThat(merged.materialNames()).hasSize(3 * MATERIALS).first().isEqualTo("m0");
        int last = merged.triangleCount() - 1;
        assertThat(merged.materialNames().get(merged.material(last))).isEqualTo("m" + (3 * MATERIALS - 1));
    }
}
