package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Triangles get their places in the order in which leaves come to them; trees of models are checked elsewhere. */
class LeafOrderTrianglesTest {
    @Test
    void thoseInNoLeafComeLast() {
        float[] corners = new float[9 * 5];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = i;
        }
        int[] leaves = {3, 1, 3, 4};

        LeafOrderTriangles triangles = LeafOrderTriangles.of(leaves, corners);

        assertThat(triangles.count()).isEqualTo(5);
        assertThat(triangles.numbers()).containsExactly(3, 1, 4, 0, 2);
        assertThat(leaves).containsExactly(0, 1, 0, 2);
        assertThat(triangles.corners()[9 * 2]).isEqualTo(36f);
        assertThat(triangles.corners()[9 * 4 + 8]).isEqualTo(26f);
    }
}
