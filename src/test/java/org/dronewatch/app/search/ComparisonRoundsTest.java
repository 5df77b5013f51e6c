package org.dronewatch.app.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Rounds in which flights show other routes each time. */
class ComparisonRoundsTest {
    private static final int MOST = 20;

    /** By round: whether it was told to be the last. */
    private final List<Boolean> rounds = new ArrayList<>();

    private Optional<Integer> unsettled(boolean isLast) {
        rounds.add(isLast);
        return isLast ? Optional.of(rounds.size()) : Optional.empty();
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "1, 2", "3, 4", "19, 20", "20, 20", "1000, 20"})
    void askedToEndThereIsOneMore(int before, int all) {
        int result = new ComparisonRounds(MOST, () -> rounds.size() >= before).result(this::unsettled);

        assertThat(result).isEqualTo(all);
        assertThat(rounds).hasSize(all);
        assertThat(rounds.subList(0, all - 1)).doesNotContain(true);
        assertThat(rounds.get(all - 1)).isTrue();
    }

    @Test
    void aRoundThatHoldsIsTheLast() {
        int result = new ComparisonRounds(MOST, () -> false).result(isLast -> {
            rounds.add(isLast);
            return rounds.size() == 3 ? Optional.of(7) : Optional.empty();
        });

        assertThat(result).isEqualTo(7);
        assertThat(rounds).containsExactly(false, false, false);
    }
}
