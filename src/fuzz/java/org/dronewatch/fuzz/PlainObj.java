package org.dronewatch.fuzz;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;

/**
 * A plain reader of OBJ files, independent of the program's: vertices and faces only, areas of polygons by Newell's
 * formula. It states how certain it is of what it read.
 */
final class PlainObj {
    /** What the reader makes of a file. */
    enum Verdict {
        /** Any reader must take it, and find the same. */
        VALID,
        /** A reader may refuse it, but whoever takes it must find the same. */
        ODD,
        /** No statement: a line is wrong, or may be read in several ways. */
        UNSURE
    }

    private static final Pattern NUMBER = Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d{1,3})?");
    private static final Pattern CORNER = Pattern.compile("(-?\\d{1,8})(/(-?\\d{1,8})?(/(-?\\d{1,8})?)?)?");
    private static final Set<String> PASSED_OVER = Set.of("vt", "vn", "g", "o", "s", "l", "p", "usemtl", "mtllib");
    /** Statements of the format that do not concern vertices and faces. */
    private static final Set<String> RARE = Set.of(
            "vp",
            "cstype",
            "deg",
            "bmat",
            "step",
            "curv",
            "curv2",
            "surf",
            "parm",
            "trim",
            "hole",
            "scrv",
            "sp",
            "end",
            "con",
            "mg",
            "bevel",
            "c_interp",
            "d_interp",
            "lod",
            "shadow_obj",
            "trace_obj",
            "ctech",
            "stech",
            "maplib",
            "usemap",
            "call",
            "csh",
            "bsp",
            "bzp",
            "cdc",
            "cdp",
            "res");

    private static final double LARGEST = 1e29;

    /** Longer lines may be refused. */
    private static final int LONGEST_LINE = 1_000_000;

    private final List<double[]> vertices = new ArrayList<>();
    private final List<int[]> faces = new ArrayList<>();
    private final Set<String> traits = new TreeSet<>();
    private boolean hasNonsense;
    private Verdict verdict = Verdict.VALID;
    private boolean areaIsKnown = true;
    private boolean extentIsKnown = true;
    private double area;
    private final double[] low = {Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE};
    private final double[] high = {-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};

    private PlainObj() {}

    static PlainObj read(String content) {
        PlainObj file = new PlainObj();
        boolean marked = content.startsWith("\uFEFF");
        String text = marked ? content.substring(1) : content;
        if (marked) {
            file.traits.add("byte order mark");
        }
        if (text.indexOf('\0') >= 0 || text.indexOf('\uFFFD') >= 0 || text.indexOf('\uFEFF') >= 0) {
            file.verdict = Verdict.UNSURE;
            return file;
        }
        StringBuilder joined = new StringBuilder();
        for (String line : text.split("\r\n|\r|\n", -1)) {
            if (line.endsWith("\\") && line.indexOf('#') >= 0) {
                // Readers differ on whether a comment continues.
                file.verdict = Verdict.UNSURE;
                return file;
            }
            if (line.endsWith("\\")) {
                joined.append(line, 0, line.length() - 1).append(' ');
                continue;
            }
            if (joined.length() + line.length() > LONGEST_LINE) {
                file.worse(Verdict.UNSURE);
            }
            file.line(joined.append(line).toString());
            joined.setLength(0);
        }
        if (joined.length() > 0) {
            file.verdict = Verdict.UNSURE;
        }
        if (file.verdict != Verdict.UNSURE) {
            file.measure();
        }
        return file;
    }

    Verdict verdict() {
        return verdict;
    }

    /**
     * Whether a line begins with a word that is no statement of the format, such as a mistyped one, whose absence
     * shifts indices.
     */
    boolean hasNonsense() {
        return hasNonsense;
    }

    /** What is special about the file, for a person. */
    Set<String> traits() {
        return traits;
    }

    boolean areaIsKnown() {
        return areaIsKnown;
    }

    boolean extentIsKnown() {
        return extentIsKnown;
    }

    /** Sum of the areas of all faces. */
    double area() {
        return area;
    }

    /** Extent of all faces along an axis. */
    double extent(int axis) {
        return high[axis] - low[axis];
    }

    private void worse(Verdict other) {
        verdict = verdict.compareTo(other) >= 0 ? verdict : other;
    }

    private void line(String whole) {
        if (whole.indexOf('\\') >= 0 || !whole.chars().allMatch(PlainObj::isPlain)) {
            // A continuation that does not continue, or a character that some readers take for white space.
            worse(Verdict.UNSURE);
            return;
        }
        int comment = whole.indexOf('#');
        String[] words =
                (comment >= 0 ? whole.substring(0, comment) : whole).trim().split("[ \t]+");
        switch (words[0]) {
            case "" -> {}
            case "v" -> vertex(words);
            case "f" -> face(words);
            // Some readers take capital letters, and the old word for a face.
            case "V", "F", "fo" -> worse(Verdict.UNSURE);
            default -> {
                if (!PASSED_OVER.contains(words[0])) {
                    traits.add("unknown keywords");
                    hasNonsense |= !RARE.contains(words[0]);
                    worse(Verdict.ODD);
                } else if (comment >= 0 || words.length < 2) {
                    worse(Verdict.UNSURE);
                } else if (words[0].startsWith("v")) {
                    passedOver(words);
                }
            }
        }
    }

    private static boolean isPlain(int c) {
        return c == ' '
                || c == '\t'
                || !Character.isISOControl(c) && !Character.isWhitespace(c) && !Character.isSpaceChar(c);
    }

    private void passedOver(String[] words) {
        for (int i = 1; i < words.length; i++) {
            if (!NUMBER.matcher(words[i]).matches()) {
                worse(Verdict.UNSURE);
            }
        }
        if (words.length > 4) {
            worse(Verdict.UNSURE);
        }
    }

    private void vertex(String[] words) {
        boolean numbers = words.length == 4 || words.length == 5 || words.length == 7;
        for (int i = 1; numbers && i < words.length; i++) {
            numbers = NUMBER.matcher(words[i]).matches();
        }
        if (!numbers) {
            worse(Verdict.UNSURE);
            return;
        }
        double[] at = new double[3];
        for (int i = 0; i < 3; i++) {
            at[i] = Float.parseFloat(words[i + 1]);
            if (!(Math.abs(at[i]) <= LARGEST)) {
                worse(Verdict.UNSURE);
            }
        }
        vertices.add(at);
    }

    private void face(String[] words) {
        if (words.length < 4) {
            worse(Verdict.UNSURE);
            return;
        }
        int[] corners = new int[words.length - 1];
        String form = form(words[1]);
        for (int i = 0; i < corners.length; i++) {
            var matcher = CORNER.matcher(words[i + 1]);
            if (!matcher.matches() || !form.equals(form(words[i + 1]))) {
                worse(Verdict.UNSURE);
                return;
            }
            int index = Integer.parseInt(matcher.group(1));
            corners[i] = index > 0 ? index - 1 : vertices.size() + index;
            if (index == 0 || corners[i] < 0) {
                worse(Verdict.UNSURE);
                return;
            }
            if (matcher.group(2) != null) {
                // Whether normals and texture coordinates exist is not checked here.
                worse(Verdict.ODD);
            }
        }
        faces.add(corners);
    }

    /** The kinds of indices that a corner has; all corners of a face must have the same. */
    private static String form(String corner) {
        return corner.replaceAll("-?\\d+", "n");
    }

    private void measure() {
        for (int[] face : faces) {
            double[][] corners = new double[face.length][];
            for (int i = 0; i < face.length; i++) {
                if (face[i] >= vertices.size()) {
                    worse(Verdict.UNSURE);
                    return;
                }
                corners[i] = vertices.get(face[i]);
            }
            measure(new Polygon(corners));
        }
        if (!(area > 0)) {
            worse(Verdict.UNSURE);
        }
    }

    private void measure(Polygon polygon) {
        double own = polygon.area();
        if (own == 0.0 && polygon.isTriangle()) {
            return;
        }
        if (polygon.isConcave()) {
            traits.add("concave polygons");
        }
        areaIsKnown &= polygon.isPlain();
        extentIsKnown &= polygon.isPlain();
        area += own;
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Math.min(low[axis], polygon.low(axis));
            high[axis] = Math.max(high[axis], polygon.high(axis));
        }
    }
}
