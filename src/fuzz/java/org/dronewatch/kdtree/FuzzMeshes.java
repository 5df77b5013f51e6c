package org.dronewatch.kdtree;

import org.dronewatch.fuzz.Dice;

/** Meshes that upset builders and traversals, with rays through their corners, along their edges, and anywhere. */
final class FuzzMeshes {
    /** The number of kinds. */
    static final int KINDS = 12;

    private final Dice dice;
    private final TriangleText mesh = new TriangleText();

    private FuzzMeshes(Dice dice) {
        this.dice = dice;
    }

    /** A mesh of one kind with rays. */
    static TriangleText of(int kind, Dice dice) {
        FuzzMeshes nasty = new FuzzMeshes(dice);
        switch (kind) {
            case 0 -> nasty.lattice();
            case 1 -> nasty.latticeFaces();
            case 2 -> nasty.fan();
            case 3 -> nasty.needles();
            case 4 -> nasty.stack();
            case 5 -> nasty.identical();
            case 6 -> nasty.soup(1f, (float) Math.pow(10, dice.between(3, 7)));
            case 7 -> nasty.squares();
            case 8 -> nasty.squares();
            case 9 -> nasty.latticeFaces();
            case 10 -> nasty.soup((float) Math.pow(10, dice.pick(-44, -42, -38, -30, 15, 25, 29)), 0f);
            default -> nasty.mixed();
        }
        boolean lattice = kind <= 1 || kind >= 7 && kind <= 9;
        for (int i = lattice ? 200 : 50; i > 0; i--) {
            nasty.ray(lattice);
        }
        return nasty.mesh;
    }

    /**
     * Unit squares of a lattice, cut in two: some of those across each axis, so that planes of a tree go through
     * corners.
     */
    private void squares() {
        int size = dice.between(2, 5);
        int share = dice.pick(1, 2, 3, 8);
        for (int i = 0; i < 3 * size * size * size; i++) {
            int axis = i % 3;
            float[] at = {i / 3 % size, i / 3 / size % size, i / 3 / size / size};
            if (!dice.oneIn(share)) {
                continue;
            }
            float[] corner = at.clone();
            corner[(axis + 1) % 3]++;
            float[] across = corner.clone();
            across[(axis + 2) % 3]++;
            float[] other = at.clone();
            other[(axis + 2) % 3]++;
            mesh.triangle(join(at, corner, across));
            mesh.triangle(join(at, across, other));
        }
        if (mesh.triangles().isEmpty()) {
            mesh.triangle(0, 0, 0, 1, 0, 0, 0, 1, 0);
        }
    }

    private static float[] join(float[] a, float[] b, float[] c) {
        return new float[] {a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]};
    }

    /** Right triangles with integer corners in planes across the axes. */
    private void latticeFaces() {
        for (int i = dice.between(1, 80); i > 0; i--) {
            int axis = dice.below(3);
            float[] from = {dice.below(9), dice.below(9), dice.below(9)};
            float[] triangle = new float[9];
            for (int corner = 0; corner < 3; corner++) {
                System.arraycopy(from, 0, triangle, 3 * corner, 3);
            }
            triangle[3 + (axis + 1) % 3] += dice.between(1, 3);
            triangle[6 + (axis + 2) % 3] += dice.between(1, 3);
            mesh.triangle(triangle);
        }
    }

    /** Triangles between arbitrary integer points. */
    private void lattice() {
        int size = dice.between(2, 8);
        for (int i = dice.between(1, 60); i > 0; i--) {
            float[] triangle = new float[9];
            for (int k = 0; k < 9; k++) {
                triangle[k] = dice.below(size + 1);
            }
            mesh.triangle(triangle);
        }
    }

    /** Triangles that share one corner, flat or as a cone. */
    private void fan() {
        int count = dice.oneIn(20) ? dice.between(500, 3000) : dice.between(3, 120);
        float height = dice.pick(0f, 1f, -100f);
        double share = dice.pick(1.0, 0.01, 0.5);
        for (int i = 0; i < count; i++) {
            double a = 2 * Math.PI * share * i / count;
            double b = 2 * Math.PI * share * (i + 1) / count;
            mesh.triangle(
                    0,
                    0,
                    height,
                    (float) Math.cos(a),
                    (float) Math.sin(a),
                    0,
                    (float) Math.cos(b),
                    (float) Math.sin(b),
                    0);
        }
    }

    /** Long thin triangles all over one another. */
    private void needles() {
        double width = Math.pow(10, -dice.between(1, 12));
        int count = dice.oneIn(20) ? dice.between(300, 1500) : dice.between(2, 100);
        for (int i = 0; i < count; i++) {
            float[] triangle = new float[9];
            for (int k = 0; k < 6; k++) {
                triangle[k] = (float) dice.between(-1.0, 1.0);
            }
            for (int k = 0; k < 3; k++) {
                triangle[6 + k] = triangle[k] + (float) (width * dice.between(-1.0, 1.0));
            }
            mesh.triangle(triangle);
        }
    }

    /** Faces in the same plane, and in planes close together. */
    private void stack() {
        int axis = dice.below(3);
        float height = dice.pick(0f, 0.1f, 0.5f, 1000f);
        for (int i = dice.between(2, 120); i > 0; i--) {
            float[] triangle = new float[9];
            float own = dice.oneIn(4) ? Math.nextUp(height) : dice.oneIn(8) ? height + dice.below(5) : height;
            for (int corner = 0; corner < 3; corner++) {
                triangle[3 * corner + axis] = own;
                triangle[3 * corner + (axis + 1) % 3] = dice.below(17) / 4f;
                triangle[3 * corner + (axis + 2) % 3] = dice.below(17) / 4f;
            }
            mesh.triangle(triangle);
        }
    }

    private void identical() {
        int count = dice.oneIn(10) ? dice.between(500, 5000) : dice.between(2, 60);
        float[] triangle = random(1f, 0f);
        for (int i = 0; i < count; i++) {
            mesh.triangle(triangle.clone());
        }
        if (dice.oneIn(2)) {
            mesh.triangle(random(1f, 0f));
        }
    }

    private void soup(float scale, float shift) {
        for (int i = dice.between(1, 80); i > 0; i--) {
            mesh.triangle(random(scale, shift));
        }
    }

    private void mixed() {
        for (int i = dice.between(2, 80); i > 0; i--) {
            mesh.triangle(random((float) Math.pow(10, dice.between(-6, 3)), 0f));
        }
    }

    private float[] random(float scale, float shift) {
        float[] triangle = new float[9];
        for (int k = 0; k < 9; k++) {
            triangle[k] = shift + scale * (float) dice.between(-1.0, 1.0);
        }
        return triangle;
    }

    private void ray(boolean lattice) {
        double[] from = point(lattice);
        double[] to = point(lattice);
        double[] ray = new double[6];
        for (int k = 0; k < 3; k++) {
            ray[k] = from[k];
            ray[3 + k] = to[k] - from[k];
        }
        if (dice.oneIn(3)) {
            // Along an axis.
            int axis = dice.below(3);
            ray[3] = dice.pick(0.0, -0.0);
            ray[4] = dice.pick(0.0, -0.0);
            ray[5] = dice.pick(0.0, -0.0);
            ray[3 + axis] = dice.pick(1.0, -1.0);
        } else if (dice.oneIn(4)) {
            ray[3 + dice.below(3)] = dice.pick(0.0, -0.0);
        }
        if (ray[3] == 0 && ray[4] == 0 && ray[5] == 0) {
            ray[3 + dice.below(3)] = 1;
        }
        mesh.ray(ray);
    }

    /** A point of the lattice, a corner, the middle of an edge, a point inside a triangle, or one near the mesh. */
    private double[] point(boolean lattice) {
        if (lattice && dice.oneIn(2)) {
            return new double[] {dice.between(-2, 11), dice.between(-2, 11), dice.between(-2, 11)};
        }
        float[] t = dice.pick(mesh.triangles());
        double[] weights =
                switch (dice.below(4)) {
                    case 0 -> new double[] {1, 0, 0};
                    case 1 -> new double[] {0.5, 0.5, 0};
                    case 2 -> new double[] {0.25, 0.25, 0.5};
                    default -> new double[] {dice.between(-2.0, 2.0), dice.between(-2.0, 2.0), dice.between(-2.0, 2.0)};
                };
        int first = dice.below(3);
        double[] point = new double[3];
        for (int k = 0; k < 3; k++) {
            for (int corner = 0; corner < 3; corner++) {
                point[k] += weights[corner] * t[3 * ((first + corner) % 3) + k];
            }
        }
        return point;
    }
}
