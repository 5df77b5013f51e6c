package org.dronewatch.render;

import org.dronewatch.parallel.Workers;
import org.dronewatch.render.canvas.Canvas;
import org.dronewatch.render.canvas.Cut;
import org.dronewatch.render.canvas.LinePainter;
import org.dronewatch.sensor.optics.CameraObject;

/** Draws rays of sound over a backdrop, and keeps the last result. */
final class RayLayer {
    private volatile Rayed rayed;

    /** A backdrop with rays, kept until others are requested: rays stay as they are while time passes. */
    private record Rayed(Backdrop backdrop, RecordedRays rays, RayFilter filter, double pixel, Canvas canvas) {
        boolean is(Backdrop other, RecordedRays otherRays, RayFilter otherFilter, double otherPixel) {
            return backdrop == other && rays == otherRays && filter.equals(otherFilter) && pixel == otherPixel;
        }
    }

    /** A backdrop with rays over it, which callers must not change. */
    Canvas over(Backdrop backdrop, RecordedRays rays, RayFilter filter, double pixel) {
        Rayed known = rayed;
        if (known == null || !known.is(backdrop, rays, filter, pixel)) {
            Canvas canvas = backdrop.canvas().copy();
            int most = backdrop.fineness().pieces;
            drawRays(backdrop.camera(), backdrop.cut().orElse(null), canvas, rays, filter, pixel, most);
            known = new Rayed(backdrop, rays, filter, pixel, canvas);
            rayed = known;
        }
        return known.canvas();
    }

    /** The more rays there are, the paler each is drawn; those that are heard are drawn last, over the others. */
    private static void drawRays(
            CameraObject camera, Cut cut, Canvas canvas, RecordedRays rays, RayFilter filter, double pixel, int most) {
        int[] shown = filter.pieces(rays, most);
        double share = shown.length > 20_000 ? 0.35 : shown.length > 2_000 ? 0.55 : 0.85;
        int bands = Math.min(canvas.height, Workers.available());
        Workers.forEach(bands, band -> {
            LinePainter lines = new LinePainter(camera, cut, canvas);
            lines.keepTo(band * canvas.height / bands, (band + 1) * canvas.height / bands);
            for (int pass = 0; pass < 2; pass++) {
                for (int piece : shown) {
                    boolean heard = rays.isHeard(piece);
                    if (heard == (pass == 1)) {
                        lines.line(
                                rays.end(piece, 0),
                                rays.end(piece, 1),
                                rays.end(piece, 2),
                                rays.end(piece, 3),
                                rays.end(piece, 4),
                                rays.end(piece, 5),
                                (heard ? 1.6 : 1.0) * pixel,
                                rays.scale().colour(rays.level(piece)),
                                heard ? 0.95 : share);
                    }
                }
            }
        });
    }
}
