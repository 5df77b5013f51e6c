/** How sound may be followed: settings of the two models, and what both know of rays. */
package org.dronewatch.sensor.acoustic.propagation;
