/** What all kinds of sensors share: settings and their capabilities, looks, observations, assessments and detections. */
package org.dronewatch.sensor;
