package org.dronewatch.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronewatch.geometry.TriangleMesh;
import org.junit.jupiter.api.Test;

/** What is kept of a site, and for how long. */
class SiteMemoryTest {
    private static final TriangleMesh GROUND = new TriangleMesh(
            new float[] {0, 0, 0, 10, 0, 0, 0, 10, 0},
            new int[] {0, 1, 2},
            new int[] {0},
            new int[] {0},
            List.of("ground"));

    private record Thing(long bytes) implements SiteMemory.Kept {}

    private static Thing of(World world, String key, long bytes) {
        return world.remembered(key, Thing.class, () -> new Thing(bytes));
    }

    @Test
    void worldsOfAMeshShareWhatOthersMakeThemselves() {
        World world = World.of(GROUND);
        SiteMemory memory = new SiteMemory(100);
        World shared = world.withMemory(memory);
        Thing first = of(shared, "a", 10);

        assertThat(of(shared.withRain(3.0), "a", 10)).isSameAs(first);
        assertThat(of(world.withMemory(memory), "a", 10)).isSameAs(first);
        assertThat(of(World.of(GROUND).withMemory(memory), "a", 10)).isNotSameAs(first);
        assertThat(of(shared, "b", 10)).isNotSameAs(first);
        assertThat(memory.made()).isEqualTo(3);
        assertThat(of(world, "a", 10)).isNotSameAs(of(world, "a", 10));
        assertThat(memory.made()).isEqualTo(3);
        assertThat(memory.bytes()).isEqualTo(30);
    }

    @Test
    void whatWasNotUsedForLongestIsDroppedWhenThereIsTooMuch() {
        SiteMemory memory = new SiteMemory(100);
        World world = World.of(GROUND).withMemory(memory);
        Thing a = of(world, "a", 60);
        Thing b = of(world, "b", 60);

        assertThat(of(world, "a", 60)).isSameAs(a);
        Thing c = of(world, "c", 60);
        assertThat(of(world, "a", 60)).isSameAs(a);
        assertThat(of(world, "c", 60)).isSameAs(c);
        assertThat(of(world, "b", 60)).isNotSameAs(b);
        assertThat(memory.bytes()).isEqualTo(120);
        for (int i = 0; i < 1000; i++) {
            of(world, "more " + i, 60);
        }
        assertThat(memory.bytes()).isEqualTo(120);
    }
}
