namespace Rabit.Uav.SensorFusion;

/// <summary>How many reports of one vehicle were refused for one reason. A plain value.</summary>
/// <param name="SourceSystemId">MAVLink system id of the vehicle that sent them; 0 where they named none.</param>
/// <param name="Fault">Why.</param>
/// <param name="Count">How many since the start.</param>
public readonly record struct RefusedReports(byte SourceSystemId, ReportFault Fault, long Count);
