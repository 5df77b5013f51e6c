package org.dronewatch.report.placement;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronewatch.placement.site.TriedBudgets;
import org.junit.jupiter.api.Test;

class FrontWordsTest {
    private static final PlaceMeasure MEASURE = new ShareMeasure(1, false, 8);

    /** In reports, amounts are written as in the tables beside them. */
    @Test
    void budgetsThatAreTooLowAreWrittenAsOtherAmounts() {
        TriedBudgets tried = new TriedBudgets(14, List.of(20_000.0, 45_000.0), false);

        assertThat(new FrontWords(MEASURE, true).tried(tried, PlaceWords::money))
                .containsExactly(
                        "14 budgets were tried: a better buy may lie between two of them.",
                        "No layout meets the conditions for these budgets, which were also tried: 20\u202f000 and"
                                + " 45\u202f000.");
    }

    @Test
    void oneBudgetIsNotSeveral() {
        FrontWords words = new FrontWords(MEASURE, true);

        assertThat(words.tried(new TriedBudgets(3, List.of(5.0), false), PlaceWords::money))
                .contains("No layout meets the conditions for this budget, which was also tried: 5.");
        assertThat(words.tried(new TriedBudgets(3, List.of(), List.of(5.0, 6.0), true), PlaceWords::money))
                .contains("The search ended before it found a layout for these budgets, so it is not known whether one"
                        + " meets the conditions: 5 and 6.");
    }

    @Test
    void whereNothingIsAskedForNoConditionsAreNamed() {
        TriedBudgets tried = new TriedBudgets(3, List.of(), List.of(5.0), true);

        assertThat(new FrontWords(MEASURE, false).tried(tried, PlaceWords::money))
                .containsExactly("The search ended before it found a layout for this budget: 5.");
        assertThat(new FrontWords(MEASURE, true).tried(tried, PlaceWords::money))
                .containsExactly("The search ended before it found a layout for this budget, so it is not known"
                        + " whether one meets the conditions: 5.");
    }

    /** The number of headings in words is that of the search. */
    @Test
    void theNumberOfHeadingsIsThatOfTheMean() {
        assertThat(new ShareMeasure(1, false, 4).headingsClause()).isEqualTo(", averaged over four headings");
        assertThat(new ShareMeasure(1, false, 16).headingsClause()).isEqualTo(", averaged over 16 headings");
        assertThat(new ShareMeasure(1, false, 1).headingsClause()).isEmpty();
    }

    /** 99.97 % is more than 99.9 %. */
    @Test
    void whatIsPrintedAsAlmostAllHasNoLowerLimit() {
        assertThat(FrontWords.moreThan(FrontWords.percent(0.958))).isEqualTo("more than 95.8 %");
        assertThat(FrontWords.moreThan(FrontWords.percent(0.9997))).isEqualTo("more than 100.0 %");
    }
}
