package org.dronewatch.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelRole;
import org.junit.jupiter.api.Test;

/** The answers of {@link Visibility} against one look at every triangle, for segments of many kinds. */
class VisibilityBruteForceTest {
    private static final int SEGMENTS = 20_000;

    /**
     * So near to the border of a triangle, of its size, a segment may be judged either way; so near to the margin, m.
     */
    private static final double EDGE = 1e-9;

    private final SplittableRandom random = new SplittableRandom(20_231);
    private final TriangleMesh mesh = soup(150);
    private final World world = World.of(mesh).withModels(models(mesh.triangleCount()));
    private int judged;
    private int hidden;

    @Test
    void betweenAnyTwoPoints() {
        compare(this::anywhere, this::anywhere);
        assertThat(hidden).as("hidden of %d", judged).isBetween(judged / 10, judged * 9 / 10);
    }

    @Test
    void fromASurface() {
        compare(this::onSurface, this::anywhere);
        compare(this::anywhere, this::onSurface);
        assertThat(hidden).as("hidden of %d", judged).isBetween(judged / 10, judged * 9 / 10);
    }

    @Test
    void fromSurfaceToSurface() {
        compare(this::onSurface, this::onSurface);
        assertThat(hidden).as("hidden of %d", judged).isBetween(judged / 10, judged * 9 / 10);
    }

    @Test
    void grazing() {
        // Along the floor, which is triangles 0 and 1: over it, under it and between a point on it and one just above.
        Supplier<Position> above = () -> new Position(in(-9, 9), in(-9, 9), random.nextDouble() * 1e-3);
        Supplier<Position> on = () -> new Position(in(-9, 9), in(-9, 9), 0.0);
        compare(above, above);
        compare(on, above);
        compare(on, on);
        assertThat(hidden).as("hidden of %d", judged).isBetween(judged / 20, judged * 19 / 20);
    }

    @Test
    void nothingStandsBetweenAPointAndItself() {
        Visibility visibility = new Visibility(world);
        for (int i = 0; i < 1000; i++) {
            Position point = i % 2 == 0 ? anywhere() : onSurface();
            assertThat(visibility.isFree(point, point)).isTrue();
            assertThat(visibility.obstacle(point, point)).isEmpty();
        }
    }

    private void compare(Supplier<Position> froms, Supplier<Position> tos) {
        Visibility visibility = new Visibility(world);
        Visibility unrelated = Visibility.ofClearPoints(world);
        for (int i = 0; i < SEGMENTS; i++) {
            Position from = froms.get();
            Position to = tos.get();
            Answer answer = ask(from, to);
            if (answer.sure) {
                judged++;
                hidden += answer.first < 0 ? 0 : 1;
                String segment = "from " + from + " to " + to;
                assertThat(visibility.isFree(from, to)).as(segment).isEqualTo(answer.first < 0);
                assertThat(unrelated.isFree(from, to)).as(segment).isEqualTo(answer.first < 0);
                assertThat(visibility.obstacle(from, to).map(Obstacle::model).map(SiteModel::file))
                        .as(segment)
                        .isEqualTo(answer.first < 0 ? Optional.empty() : Optional.of(name(answer.first)));
            }
        }
    }

    /** What a segment meets first, -1 for nothing; whether that is clear of rounding. */
    private record Answer(int first, boolean sure) {}

    private Answer ask(Position from, Position to) {
        double length = from.distance(to);
        double margin = Visibility.MARGIN;
        int first = -1;
        double nearest = Double.POSITIVE_INFINITY;
        boolean sure = true;
        for (int triangle = 0; triangle < mesh.triangleCount(); triangle++) {
            Position a = corner(triangle, 0);
            Position b = corner(triangle, 1);
            Position c = corner(triangle, 2);
            Position normal = cross(b.minus(a), c.minus(a));
            double before = from.minus(a).dot(normal);
            double after = to.minus(a).dot(normal);
            // Whether a triangle hides the points of its own plane from each other is a matter of rounding.
            double rounding = EDGE * Math.sqrt(normal.dot(normal));
            sure &= Math.abs(before) > rounding || Math.abs(after) > rounding;
            if (before == after) {
                continue;
            }
            double way = before / (before - after) * length;
            Position at = from.plus(to.minus(from).times(way / length));
            double inside = inside(at, a, b, c, normal);
            boolean counts = way > margin && way < length - margin;
            boolean close = Math.abs(way - margin) < EDGE * length || Math.abs(length - margin - way) < EDGE * length;
            sure &= !(close && inside > -EDGE) && !(counts && Math.abs(inside) < EDGE);
            if (counts && inside > 0.0) {
                sure &= first < 0 || Math.abs(way - nearest) > EDGE * length;
                if (way < nearest) {
                    nearest = way;
                    first = triangle;
                }
            }
        }
        return new Answer(first, sure);
    }

    /** The smallest barycentric weight of a point of a triangle's plane: negative outside. */
    private static double inside(Position at, Position a, Position b, Position c, Position normal) {
        double area = normal.dot(normal);
        double ofA = cross(c.minus(b), at.minus(b)).dot(normal) / area;
        double ofB = cross(a.minus(c), at.minus(c)).dot(normal) / area;
        return Math.min(Math.min(ofA, ofB), 1.0 - ofA - ofB);
    }

    private static Position cross(Position a, Position b) {
        return new Position(
                a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x());
    }

    private Position corner(int triangle, int corner) {
        return new Position(
                mesh.coordinate(triangle, corner, 0),
                mesh.coordinate(triangle, corner, 1),
                mesh.coordinate(triangle, corner, 2));
    }

    private Position anywhere() {
        return new Position(in(-10, 10), in(-10, 10), in(-10, 10));
    }

    private Position onSurface() {
        int triangle = random.nextInt(mesh.triangleCount());
        double u = random.nextDouble();
        double v = random.nextDouble();
        if (u + v > 1.0) {
            u = 1.0 - u;
            v = 1.0 - v;
        }
        Position a = corner(triangle, 0);
        return a.plus(corner(triangle, 1).minus(a).times(u))
                .plus(corner(triangle, 2).minus(a).times(v));
    }

    private double in(double low, double high) {
        return low + (high - low) * random.nextDouble();
    }

    /** A level floor of two triangles, and others anywhere. */
    private TriangleMesh soup(int count) {
        float[] vertices = new float[12 + 9 * count];
        System.arraycopy(new float[] {-9, -9, 0, 9, -9, 0, 9, 9, 0, -9, 9, 0}, 0, vertices, 0, 12);
        List<Integer> corners = new ArrayList<>(List.of(0, 1, 2, 0, 2, 3));
        for (int i = 0; i < count; i++) {
            Position middle = anywhere();
            for (int corner = 0; corner < 3; corner++) {
                int at = 12 + 9 * i + 3 * corner;
                vertices[at] = (float) (middle.x() + in(-2, 2));
                vertices[at + 1] = (float) (middle.y() + in(-2, 2));
                vertices[at + 2] = (float) (middle.z() + in(-2, 2));
                corners.add(4 + 3 * i + corner);
            }
        }
        return TriangleMesh.of(
                vertices, corners.stream().mapToInt(Integer::intValue).toArray());
    }

    private static NavigableMap<Integer, SiteModel> models(int count) {
        NavigableMap<Integer, SiteModel> models = new TreeMap<>();
        for (int triangle = 0; triangle < count; triangle++) {
            models.put(triangle, new SiteModel(name(triangle), ModelRole.BUILDING));
        }
        return models;
    }

    private static String name(int triangle) {
        return "triangle " + triangle;
    }
}
