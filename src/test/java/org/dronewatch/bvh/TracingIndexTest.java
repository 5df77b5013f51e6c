package org.dronewatch.bvh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.Meshes;
import org.dronewatch.parallel.VectorInstructions;
import org.dronewatch.parallel.Workers;
import org.junit.jupiter.api.Test;

class TracingIndexTest {
    @Test
    void allThreadsShareOneBvh() {
        assumeTrue(VectorInstructions.areAvailable(), "no vectors of 256 bits, or the module of vectors is not named");
        TracingIndex index = TracingIndex.of(Meshes.model("house.obj"));
        Set<Bvh> built = Collections.synchronizedSet(Collections.newSetFromMap(new IdentityHashMap<>()));
        try (Workers workers = new Workers(3)) {
            workers.call(() -> {
                Workers.forEach(100, number -> built.add(index.bvh()));
                return null;
            });
        }
        assertThat(built).hasSize(1);
    }

    @Test
    void incoherentRaysOfAnEmptyMeshHitNothing() {
        TracingIndex index = TracingIndex.of(TriangleMesh.of(new float[0], new int[0]));
        assertThat(index.hasBvh()).isFalse();
        assertThat(index.newIncoherentRayTracer().closestHit(0, 0, 0, 0, 0, 1, 0, Double.POSITIVE_INFINITY))
                .isFalse();
    }

    /** A triangle is as far away as its farthest corner, on whichever axis and side. */
    @Test
    void farTrianglesHaveNoBvh() {
        for (int coordinate = 0; coordinate < 9; coordinate++) {
            for (float far : new float[] {-1e20f, 1e20f}) {
                float[] corners = {0, 0, 0, 1, 0, 0, 0, 1, 1};
                corners[coordinate] = far;
                TracingIndex index = TracingIndex.of(TriangleMesh.of(corners, new int[] {0, 1, 2}));
                assertThat(index.hasBvh()).as("%g", far).isFalse();
            }
        }
    }
}
