namespace Rabit.Tool.TelemetryLogs;

/// <summary>What comes out.</summary>
internal enum DumpFormat
{
    /// <summary>Who sent what, how often, and what was lost.</summary>
    Table,

    /// <summary>One line for people per message.</summary>
    Lines,

    /// <summary>Comma-separated values, one row per message.</summary>
    Csv,

    /// <summary>One JSON object per line and message.</summary>
    Json,
}
