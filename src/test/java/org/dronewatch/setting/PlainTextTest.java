package org.dronewatch.setting;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class PlainTextTest {
    private static final String STEERING =
            "\u0000\u0007\u001b\u007f\u0080\u009b\u061c\u200e\u200f\u202a\u202b\u202c\u202d"
                    + "\u202e\u2066\u2067\u2068\u2069\ufeff\ud800";

    @Test
    void whatSteersATerminalIsWrittenOut() {
        assertThat(PlainText.line("a\u001b[31mred\u001b[0m")).isEqualTo("a\\u001b[31mred\\u001b[0m");
        assertThat(PlainText.line("a" + STEERING + "b"))
                .startsWith("a\\u0000\\u0007\\u001b")
                .endsWith("\\ufeff\\ud800b")
                .matches("[ -~]+");
        assertThat(PlainText.lines("a\u0085b\u2028c\u2029d\u009be")).isEqualTo("a b c d\\u009be");
    }

    @Test
    void aMessageIsOneLine() {
        assertThat(PlainText.line(" one\r\ntwo\n\n\tthree\u2028four\u0085five "))
                .isEqualTo("one two three four five");
        assertThat(PlainText.lines("one\r\n\ttwo\n\rthree")).isEqualTo("one\r\n\ttwo\n three");
    }

    /** Joiners belong to words of Persian and to pictures of families. */
    @Test
    void namesOfAllLanguagesStayAsTheyAre() {
        String names = "Krásná Hora, 東京, מגדל, می\u200cخواهم, \ud83d\ude81, \ud83d\udc68\u200d\ud83d\udc69";
        assertThat(PlainText.line(names)).isEqualTo(names);
        assertThat(PlainText.value(names)).isEqualTo(names);
    }

    @Test
    void ofALongValueTwoHundredCharactersAreRepeatedAndThePlaceAndTheLimitStay() {
        String value = "x y ".repeat(5000);
        String line = PlainText.line("site.yaml:3:1: the site's width: '" + value + "': must be 1 to 16384");
        assertThat(line).startsWith("site.yaml:3:1: the site's width: 'x y ").endsWith("': must be 1 to 16384");
        assertThat(line.length()).isBetween(200, 270);
        assertThat(PlainText.line("--out " + "z".repeat(5000) + ": not a path"))
                .startsWith("--out zzz")
                .endsWith("zzz: not a path")
                .hasSizeLessThan(230);
        assertThat(PlainText.value(value)).hasSize(200);
    }

    /** What stands between the end of one quotation and the beginning of the next is no quotation. */
    @Test
    void listsBetweenQuotationsAreKept() {
        String list = "'a' is not one of these: " + "name, ".repeat(60) + "but not 'b'";
        assertThat(PlainText.line(list)).isEqualTo(list);
    }

    @Test
    void noCharacterIsCutInHalf() {
        SplittableRandom random = new SplittableRandom(7);
        for (int i = 0; i < 500; i++) {
            String value = "a".repeat(random.nextInt(300)) + "\ud83d\ude81".repeat(random.nextInt(300));
            assertThat(PlainText.value(value).codePoints())
                    .as("seed 7, value %d", i)
                    .allMatch(c -> Character.getType(c) != Character.SURROGATE);
            assertThat(PlainText.value(value).length()).isLessThanOrEqualTo(PlainText.LONGEST);
        }
    }

    @Test
    void inputExceptionsShowPlainText() {
        InputException problem = new InputException("'\u001b]0;title\u0007" + "v".repeat(1000) + "': no");
        assertThat(problem.getMessage()).startsWith("'\\u001b]0;title\\u0007v").hasSizeLessThan(220);
    }

    @Test
    void theBeginningOfATextEndsBeforeHalfACharacter() {
        assertThat(PlainText.beginning("four", 4)).isEqualTo("four");
        assertThat(PlainText.beginning("fives", 4)).isEqualTo("five...");
        assertThat(PlainText.beginning("abc\uD83D\uDE81d", 4)).isEqualTo("abc...");
    }

    @Test
    void wordsInARow() {
        assertThat(PlainText.list(List.of())).isEmpty();
        assertThat(PlainText.list(List.of("a"))).isEqualTo("a");
        assertThat(PlainText.list(List.of("a", "b"))).isEqualTo("a and b");
        assertThat(PlainText.list(List.of("a, b", "c", "d"))).isEqualTo("a, b, c and d");
    }
}
