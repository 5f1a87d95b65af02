namespace Rabit.Uav.Messages;

/// <summary>The state of health, posted at least once a second. A plain value.</summary>
/// <example>
/// <code>
/// MessageSubscriber&lt;HealthReport&gt; health = reactor.Workspace.Subscribe&lt;HealthReport&gt;(MessageNames.Health);
/// if (health.Fetch() &amp;&amp; health.Value.Level == HealthLevel.Critical)
///     Console.WriteLine(health.Value.Text);   // "battery nearly empty (9 %); link udpin:0.0.0.0:14550 is silent"
/// </code>
/// </example>
public struct HealthReport
{
    /// <summary>The most severe level of all reasons.</summary>
    public HealthLevel Level { get; set; }

    /// <summary>What is wrong.</summary>
    public HealthReasons Reasons { get; set; }

    /// <summary>The reasons as text, with names and figures; null when nothing is wrong.</summary>
    public string? Text { get; set; }

    /// <summary>What Mission Control is advised to do.</summary>
    public HealthAdvice Advice { get; set; }

    /// <summary>
    /// The reason of the advice, as text, to return or to land also when it no longer holds; null without advice.
    /// </summary>
    public string? AdviceText { get; set; }

    /// <summary>Whether our own heartbeat is sent: only while every manager works.</summary>
    public bool SendsHeartbeat { get; set; }

    /// <summary>How the companion computer is, by the last look at it.</summary>
    public ComputerStatus Computer { get; set; }

    /// <summary>Own heartbeats that were pushed to Communications.</summary>
    public long HeartbeatsSent { get; set; }
}
