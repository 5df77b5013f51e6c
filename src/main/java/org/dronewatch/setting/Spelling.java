package org.dronewatch.setting;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/** Suggests names for misspelt ones. */
public final class Spelling {
    private static final double LEFT_OVER = 0.2;

    private static final int SUGGESTIONS = 3;

    /** Maximum number of names in a message that lists them all. */
    private static final int LISTED = 20;

    /** Maximum number of characters of the typed text that are compared; every name is shorter. */
    private static final int LONGEST = 200;

    private Spelling() {}

    /**
     * The names nearest to a mistyped one, nearest first. The distance is the number of letters that must be changed,
     * added or removed; case does not matter.
     */
    public static List<String> nearest(String typed, Collection<String> names, int count) {
        return names.stream()
                .sorted(Comparator.<String>comparingDouble(name -> distance(typed, name))
                        .thenComparing(Comparator.naturalOrder()))
                .limit(count)
                .toList();
    }

    /** The nearest name, if it is similar enough to be the one that was meant: about one letter in four may differ. */
    public static Optional<String> meant(String typed, Collection<String> names) {
        return nearest(typed, names, 1).stream()
                .filter(name -> distance(typed, name) <= 1.0 + 0.25 * Math.min(typed.length(), LONGEST))
                .findFirst();
    }

    /** A question at the end of a message: {@code ; did you mean 'camera'?}; empty if no name is similar enough. */
    public static String didYouMean(String typed, Collection<String> names) {
        return meant(typed, names).map(Spelling::question).orElse("");
    }

    /** The question {@code ; did you mean 'camera'?}, for the end of a message. */
    public static String question(String name) {
        return "; did you mean '" + name + "'?";
    }

    /**
     * The last part of a message about an unknown name: {@code closest matches: camera, radar}, or
     * {@code closest match: camera}.
     */
    public static String closestMatches(String typed, Collection<String> names) {
        List<String> nearest = nearest(typed, names, SUGGESTIONS);
        if (nearest.isEmpty()) {
            return "there are none to choose from";
        }
        return (nearest.size() == 1 ? "closest match: " : "closest matches: ") + String.join(", ", nearest);
    }

    /**
     * A message about an unknown name: {@code no sensor 'radr'; the scene has radar, roof}.
     *
     * @param what the kind of thing with that name, in the singular, such as {@code sensor}
     * @param owner what contains the things that exist, such as {@code the scene}
     * @param names the names that exist; the first {@value #LISTED} are listed
     */
    public static String unknown(String what, String typed, String owner, Collection<String> names) {
        String list = names.stream().limit(LISTED).map(PlainText::value).collect(Collectors.joining(", "));
        return "no " + what + " '" + PlainText.value(typed) + "'; " + owner + " has "
                + (names.isEmpty() ? "no " + what + "s" : list)
                + (names.size() > LISTED ? ", ..." : "");
    }

    /**
     * Levenshtein's distance, computed row by row, to the name or to the beginning of the name that fits best: {@code
     * brik} is meant for {@code brick_rough}, not for {@code solid}. The rest of the name counts a little.
     */
    private static double distance(String typed, String name) {
        // A longer text cannot be meant as a name; what a file has instead of a name may be of any length.
        String a = typed.substring(0, Math.min(typed.length(), LONGEST)).toLowerCase(Locale.ROOT);
        String b = name.toLowerCase(Locale.ROOT);
        int[] row = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            row[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int changed = diagonal + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.min(changed, 1 + Math.min(row[j], row[j - 1]));
            }
        }
        double best = row[b.length()];
        for (int j = 0; j < b.length(); j++) {
            best = Math.min(best, row[j] + LEFT_OVER * (b.length() - j));
        }
        return best;
    }
}
