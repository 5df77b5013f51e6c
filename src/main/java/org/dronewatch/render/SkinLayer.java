package org.dronewatch.render;

import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.render.canvas.Canvas;

/** Lays a skin over a backdrop, and keeps the last result: it stays the same as time passes. */
final class SkinLayer {
    /**
     * The cosine of the greatest slope of a surface that faces up: 75 degrees, so that steep hillsides and roofs face
     * up, but not walls.
     */
    private static final double LEAST_UPWARD = 0.26;

    private final Facets facets;
    private volatile Skinned last;

    private record Skinned(Backdrop below, SiteSkin skin, double scale, Backdrop painted) {
        boolean is(Backdrop backdrop, SiteSkin other, double otherScale) {
            return below == backdrop && skin == other && scale == otherScale;
        }
    }

    SkinLayer(Facets facets) {
        this.facets = facets;
    }

    /**
     * A backdrop with a skin over it; the one below remains unchanged.
     *
     * @param scale pixels of the picture per pixel of one of normal density
     */
    Backdrop over(Backdrop below, SiteSkin skin, double scale) {
        Skinned known = last;
        if (known == null || !known.is(below, skin, scale)) {
            known = new Skinned(below, skin, scale, painted(below, skin, scale));
            last = known;
        }
        return known.painted();
    }

    private Backdrop painted(Backdrop below, SiteSkin skin, double scale) {
        Canvas canvas = below.canvas().copy();
        double[][] grid = below.camera().grid();
        Position eye = below.camera().position();
        double step = below.width() / (scale * canvas.width);
        Workers.forEach(canvas.height, row -> {
            double acrossEast = grid[1][0];
            double acrossNorth = grid[1][1];
            double firstEast = grid[0][0] + row * grid[2][0];
            double firstNorth = grid[0][1] + row * grid[2][1];
            for (int column = 0; column < canvas.width; column++) {
                int pixel = row * canvas.width + column;
                int triangle = canvas.triangle[pixel];
                if (triangle != Canvas.NOTHING && facets.normal(triangle, 2) > LEAST_UPWARD) {
                    double depth = canvas.depth[pixel];
                    double east = eye.x() + depth * (firstEast + column * acrossEast);
                    double north = eye.y() + depth * (firstNorth + column * acrossNorth);
                    canvas.rgb[pixel] =
                            skin.colour(east, north, (int) (step * column), (int) (step * row), canvas.rgb[pixel]);
                }
            }
        });
        return below.withCanvas(canvas);
    }
}
