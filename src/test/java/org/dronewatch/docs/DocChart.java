package org.dronewatch.docs;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** The style of the charts that the docs draw, apart from those of the report. */
final class DocChart {
    /** Of a chart that has another one beside it, pixels. */
    static final int HALF_WIDTH = 640;

    private static final int HEIGHT = 520;
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 14);
    private static final Font TITLE_FONT = new Font(Font.SANS_SERIF, Font.BOLD, 16);

    private DocChart() {}

    /** A chart without lines. */
    static XYChart of(int width, String title, String x, String y) {
        XYChart chart = new XYChartBuilder()
                .width(width)
                .height(HEIGHT)
                .title(title)
                .xAxisTitle(x)
                .yAxisTitle(y)
                .build();
        chart.getStyler().setLegendFont(FONT).setChartTitleFont(TITLE_FONT).setChartBackgroundColor(Color.WHITE);
        chart.getStyler()
                .setPlotGridLinesColor(new Color(0xdddddd))
                .setAxisTitleFont(FONT)
                .setAxisTickLabelsFont(FONT);
        return chart;
    }

    /** Adds a line. */
    static void add(XYChart chart, String name, double[] x, double[] y, Color colour) {
        add(chart, name, x, y, colour, 2F);
    }

    /** Adds a line of a width, pixels. */
    static void add(XYChart chart, String name, double[] x, double[] y, Color colour, float width) {
        chart.addSeries(name, x, y)
                .setMarker(SeriesMarkers.NONE)
                .setLineColor(colour)
                .setLineStyle(new BasicStroke(width));
    }

    /** Two charts of half the width side by side. */
    static BufferedImage beside(XYChart left, XYChart right) {
        BufferedImage both = new BufferedImage(2 * HALF_WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = both.createGraphics();
        graphics.drawImage(BitmapEncoder.getBufferedImage(left), 0, 0, null);
        graphics.drawImage(BitmapEncoder.getBufferedImage(right), HALF_WIDTH, 0, null);
        graphics.dispose();
        return both;
    }
}
