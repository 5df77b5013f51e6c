/** Real sensors by name: the only package that knows every kind of sensor. */
package org.dronewatch.catalog;
