package org.dronewatch.render.photo;

import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.world.Clearance;
import org.dronewatch.world.Visibility;

/**
 * The light that matt surfaces send to the camera: Lambert's cosine law for the sun, with a shadow ray, and the light
 * of the sky, of which corners receive less. How much less is their obscurance: rays into the hemisphere count more
 * the farther they get (Zhukov, Iones and Kronin, "An ambient light illumination model", 1998). For use by one thread.
 */
final class Shading {
    /** Distance at which a hit takes away 1/e of a ray's light, m. */
    private static final double REACH = 4.0;

    /** Accuracy of hits, as a fraction of their distance: pixels are traced in single precision. */
    private static final double ROUNDING = 1e-6;

    /** Golden angle, rad: successive rays of a spiral are rotated by it, so that they do not line up. */
    private static final double GOLDEN_ANGLE = Math.PI * (3.0 - Math.sqrt(5.0));

    private final SceneLight light;
    private final Visibility visibility;
    private final RayTracer tracer;
    private final Position sun;
    private final int rays;
    private final double[] terms = AmbientLight.newTerms();
    private final double[] scratch = new double[Daylight.CHANNELS];
    private final double[] point = new double[3];

    /** @param rays number of rays into the hemisphere above the surface that a part of a pixel shows */
    Shading(SceneLight light, int rays) {
        this.light = light;
        this.visibility = new Visibility(light.world());
        this.tracer = light.world().newRayTracer();
        this.sun = light.daylight().toSun().orElse(new Position(0, 0, 1));
        this.rays = rays;
    }

    /**
     * Writes the radiance of a surface towards the camera.
     *
     * @param from position of the camera, m
     * @param direction direction from the camera to the surface, of unit length
     * @param distance distance from the camera to the surface, m
     * @param normal normal of the surface, to either side and of any length; afterwards of unit length and towards the
     *     camera
     * @param surfaces surfaces of the mesh to which the surface belongs
     * @param part number of the part of a pixel that is shaded
     * @param parts how many parts a pixel has, which share the rays into the hemisphere
     * @param corners whether corners are darker, as those of the world are
     */
    void shade(
            Position from,
            double[] direction,
            double distance,
            double[] normal,
            Surfaces surfaces,
            int triangle,
            int part,
            int parts,
            boolean corners,
            double[] rgb) {
        turn(normal, direction);
        double gap = Clearance.GAP + ROUNDING * distance;
        point[0] = from.x() + distance * direction[0] + gap * normal[0];
        point[1] = from.y() + distance * direction[1] + gap * normal[1];
        point[2] = from.z() + distance * direction[2] + gap * normal[2];
        irradiance(normal, corners ? openness(normal, part, parts) : 1.0, rgb);
        int material = surfaces.material(triangle, point[0], point[1]);
        for (int i = 0; i < Daylight.CHANNELS; i++) {
            rgb[i] *= surfaces.reflectance(material, i);
        }
        light.addHaze(direction, distance, rgb, scratch);
    }

    private static void turn(double[] normal, double[] direction) {
        double length = Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        double facing = normal[0] * direction[0] + normal[1] * direction[1] + normal[2] * direction[2];
        double scale = (facing > 0.0 ? -1.0 : 1.0) / Math.max(Double.MIN_NORMAL, length);
        for (int i = 0; i < normal.length; i++) {
            normal[i] *= scale;
        }
    }

    private void irradiance(double[] normal, double open, double[] rgb) {
        rgb[0] = 0.0;
        rgb[1] = 0.0;
        rgb[2] = 0.0;
        light.ambient().addTo(rgb, open, normal, terms);
        double cos = normal[0] * sun.x() + normal[1] * sun.y() + normal[2] * sun.z();
        if (light.daylight().isSunny() && cos > 0.0 && seesSun()) {
            for (int i = 0; i < Daylight.CHANNELS; i++) {
                rgb[i] += cos * light.daylight().direct(i);
            }
        }
    }

    private boolean seesSun() {
        return visibility.isFreeAlong(
                point[0], point[1], point[2], sun.x(), sun.y(), sun.z(), Double.POSITIVE_INFINITY);
    }

    /** The fraction of the light from all around that reaches the point, by rays distributed by the cosine law. */
    private double openness(double[] normal, int part, int of) {
        // An orthonormal frame around the normal (Duff et al., JCGT 6, 2017).
        double sign = normal[2] < 0.0 ? -1.0 : 1.0;
        double a = -1.0 / (sign + normal[2]);
        double b = normal[0] * normal[1] * a;
        double sum = 0.0;
        for (int i = part; i < of * rays; i += of) {
            double share = (i + 0.5) / (of * rays);
            double radius = Math.sqrt(share);
            double angle = i * GOLDEN_ANGLE;
            double u = radius * Math.cos(angle);
            double v = radius * Math.sin(angle);
            double w = Math.sqrt(1.0 - share);
            double x = u * (1.0 + sign * normal[0] * normal[0] * a) + v * b + w * normal[0];
            double y = u * sign * b + v * (sign + normal[1] * normal[1] * a) + w * normal[1];
            double z = -u * sign * normal[0] - v * normal[1] + w * normal[2];
            boolean hit = tracer.closestHit(point[0], point[1], point[2], x, y, z, 0.0, 8.0 * REACH);
            sum += hit ? 1.0 - Math.exp(-tracer.distance() / REACH) : 1.0;
        }
        return sum / rays;
    }
}
