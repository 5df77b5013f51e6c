package org.dronewatch.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** A list keeps its values while it grows far beyond its first room. */
class FloatsTest {
    private static final int MANY = 5000;

    private final Floats list = new Floats();

    private static float value(int i) {
        return 0.5f * i;
    }

    private void addMany() {
        for (int i = 0; i < MANY; i++) {
            list.add(value(i));
        }
    }

    @Test
    void isEmptyAtFirst() {
        assertThat(list.size()).isZero();
        assertThat(list.toArray()).isEmpty();
    }

    @Test
    void keepsEachValueInItsPlace() {
        addMany();

        assertThat(list.size()).isEqualTo(MANY);
        float[] copy = list.toArray();
        assertThat(copy).hasSize(MANY);
        for (int i = 0; i < MANY; i++) {
            assertThat(list.get(i)).isEqualTo(value(i));
            assertThat(copy[i]).isEqualTo(value(i));
        }
    }

    @Test
    void beginsAnewOnceCleared() {
        addMany();
        list.clear();
        list.add(value(7));

        assertThat(list.toArray()).containsExactly(value(7));
    }

    @Test
    void cannotBeChangedThroughItsCopies() {
        list.add(value(7));
        list.toArray()[0] = value(8);

        assertThat(list.get(0)).isEqualTo(value(7));
    }
}
