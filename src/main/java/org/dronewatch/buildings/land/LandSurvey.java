package org.dronewatch.buildings.land;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.dronewatch.buildings.io.MapLand;
import org.dronewatch.buildings.io.MapShape;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;

/**
 * The land cover of a map, drawn into a raster, with the lines of the report about it. The cover is drawn in this
 * order: the sea; areas, the larger ones first; waterways; lakes; paved areas; railways; paths; roads.
 */
public final class LandSurvey {
    private static final int EXAMPLES = 3;

    private final LandPainter painter;
    private final UnaryOperator<double[]> inWorld;
    private final List<Drawn> drawn = new ArrayList<>();
    private final List<double[]> coast = new ArrayList<>();
    private final List<String> cutOff = new ArrayList<>();
    private int offTheGround;

    private record Drawn(LandUse use, List<double[]> lines, double area) {}

    private LandSurvey(MapLand land, double half, UnaryOperator<double[]> inWorld) {
        this.painter = new LandPainter(half);
        this.inWorld = inWorld;
        land.shapes().forEach(this::sort);
    }

    /**
     * What a survey found.
     *
     * @param cover the land cover
     * @param description description of the cover, in lines for the report
     * @param warnings warnings about what is missing, one line each
     */
    public record Found(LandRaster cover, List<String> description, List<String> warnings) {
        /** Copies the lists: later changes by the caller have no effect. */
        public Found {
            description = List.copyOf(description);
            warnings = List.copyOf(warnings);
        }
    }

    /**
     * Draws the land cover of a map.
     *
     * @param file name of the map, for warnings
     * @param land the land cover of the map
     * @param half half the length of a side of the square around the origin in which land cover is drawn, m
     * @param inWorld transforms coordinates of the map to the world frame, m: x and y of each corner in turn
     */
    public static Found of(String file, MapLand land, double half, UnaryOperator<double[]> inWorld) {
        LandSurvey survey = new LandSurvey(land, half, inWorld);
        LandRaster cover = survey.draw();
        double[] areas = cover.areas();
        List<String> warnings = new ArrayList<>();
        if (!cover.isAnywhere()) {
            warnings.add(file + ": has no land cover near the origin: all ground keeps its material");
        }
        survey.warning(file).ifPresent(warnings::add);
        return new Found(cover, survey.lines(cover, areas), warnings);
    }

    private void sort(MapShape shape) {
        Map<String, String> tags = shape.tags();
        Optional<LandUse> area = LandTags.area(tags);
        Optional<LandUse> use = area.filter(any -> shape.isClosed()).or(() -> LandTags.line(tags));
        if (LandTags.isCoastline(tags)) {
            shape.lines().forEach(line -> coast.add(inWorld.apply(shape.isClosed() ? closed(line) : line)));
        } else if (use.isPresent() && LandTags.isOffTheGround(tags)) {
            offTheGround++;
        } else if (use.isPresent()) {
            add(use.get(), shape);
        } else if (area.isPresent() && shape.lines().stream().anyMatch(line -> isNear(inWorld.apply(line)))) {
            cutOff.add(shape.id());
        }
    }

    /** Whether the box around a line overlaps the square. */
    private boolean isNear(double[] line) {
        double half = painter.half();
        boolean[] sides = new boolean[4];
        for (int i = 0; i < line.length; i += 2) {
            sides[0] |= line[i] >= -half;
            sides[1] |= line[i] <= half;
            sides[2] |= line[i + 1] >= -half;
            sides[3] |= line[i + 1] <= half;
        }
        return sides[0] && sides[1] && sides[2] && sides[3];
    }

    private void add(LandUse use, MapShape shape) {
        List<double[]> lines = shape.lines().stream()
                .map(line -> use.isArea() || !shape.isClosed() ? line : closed(line))
                .map(inWorld)
                .toList();
        double area = use.isArea()
                ? lines.stream().mapToDouble(LandSurvey::area).max().orElse(0.0)
                : 0.0;
        drawn.add(new Drawn(use, lines, area));
    }

    /** A ring with its first corner repeated at the end. */
    private static double[] closed(double[] ring) {
        double[] line = Arrays.copyOf(ring, ring.length + 2);
        System.arraycopy(ring, 0, line, ring.length, Math.min(2, ring.length));
        return line;
    }

    private static double area(double[] ring) {
        double twice = 0.0;
        for (int i = 2; i + 3 < ring.length; i += 2) {
            twice += (ring[i] - ring[0]) * (ring[i + 3] - ring[1]) - (ring[i + 2] - ring[0]) * (ring[i + 1] - ring[1]);
        }
        return 0.5 * Math.abs(twice);
    }

    private LandRaster draw() {
        new Coast(coast).paint(painter, LandClass.WATER);
        drawn.sort(Comparator.comparing((Drawn one) -> one.use.layer())
                .thenComparing(Comparator.comparingDouble(Drawn::area).reversed()));
        for (Drawn one : drawn) {
            LandUse use = one.use;
            if (use.isArea()) {
                painter.fill(one.lines, use.land());
            } else {
                one.lines.forEach(line -> painter.stroke(line, use.width(), use.land()));
            }
        }
        return painter.cover();
    }

    private List<String> lines(LandRaster cover, double[] areas) {
        String classes = LandClass.all().stream()
                .filter(land -> land != LandClass.NONE && areas[land.code()] > 0.0)
                .sorted(Comparator.comparingDouble((LandClass land) -> areas[land.code()])
                        .reversed())
                .map(land -> String.format(Locale.ROOT, "%s %,.0f m2", land.words(), areas[land.code()]))
                .collect(Collectors.joining(", "));
        List<String> lines = new ArrayList<>();
        lines.add(String.format(
                Locale.ROOT,
                "land cover: %d x %d cells of %s: %s; not stated for %.0f %%",
                cover.side(),
                cover.side(),
                Quantity.LENGTH.inWords(cover.cell()),
                classes.isEmpty() ? "none" : classes,
                100.0
                        * areas[0]
                        / IntStream.range(0, areas.length)
                                .mapToDouble(i -> areas[i])
                                .sum()));
        if (offTheGround > 0) {
            lines.add(String.format(
                    Locale.ROOT,
                    "land cover: left out: %,d %s",
                    offTheGround,
                    offTheGround == 1
                            ? "road or area on a bridge, in a tunnel or underground"
                            : "roads and areas on bridges, in tunnels or underground"));
        }
        return lines;
    }

    private Optional<String> warning(String file) {
        return cutOff.isEmpty()
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "%s: land cover: %,d %s left out: %s%s;"
                                + " 'osmium extract --strategy smart' extracts a map with complete areas",
                        file,
                        cutOff.size(),
                        cutOff.size() == 1
                                ? "area whose outline is incomplete in the file is"
                                : "areas whose outlines are incomplete in the file are",
                        cutOff.stream().limit(EXAMPLES).map(PlainText::value).collect(Collectors.joining(", ")),
                        cutOff.size() > EXAMPLES ? ", ..." : ""));
    }
}
