package org.dronewatch.run.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class RecentTest {
    @Test
    void theLastUsedValuesAreKept() {
        List<Integer> made = new ArrayList<>();
        Recent<Integer, String> recent = new Recent<>(3);
        for (int key : new int[] {1, 2, 3, 1, 4, 1, 2, 3, 4}) {
            String value = recent.computeIfAbsent(key, number -> {
                made.add(number);
                return "value " + number;
            });
            assertThat(value).isEqualTo("value " + key);
        }

        // 4 takes the place of 2, 2 that of 3, 3 that of 4, and 4 that of 1.
        assertThat(made).containsExactly(1, 2, 3, 4, 2, 3, 4);
        assertThat(recent.get(1)).isNull();
        assertThat(recent.get(4)).isEqualTo("value 4");
    }
}
