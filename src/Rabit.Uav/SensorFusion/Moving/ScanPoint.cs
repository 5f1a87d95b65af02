namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>A point of a scan: a target, or clutter. A plain value.</summary>
/// <param name="Measurement">Where it was; the time is that of the scan, or its own within the scan.</param>
/// <param name="Class">The number of its class.</param>
/// <param name="Marker">The number on it; negative where none was read.</param>
internal readonly record struct ScanPoint(TrackMeasurement Measurement, int Class, int Marker);
