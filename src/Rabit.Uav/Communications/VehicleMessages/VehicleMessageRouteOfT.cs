using System;

namespace Rabit.Uav.Communications;

/// <summary>
/// Vehicle messages of one type: what is pushed into one queue here comes out of another queue on the other vehicle.
/// </summary>
/// <example>
/// <code>
/// options.Communications.VehicleMessageRoutes =
/// [
///     new VehicleMessageRoute&lt;WindSample&gt;(
///         new WindSampleCodec(), outgoingQueue: "wind out", incomingQueue: "wind in")
///     {
///         Class = VehicleMessageClass.State,
///         Lifetime = TimeSpan.FromSeconds(5),
///     },
/// ];
/// // in a manager: Send&lt;Envelope&lt;WindSample&gt;&gt;("wind out"),
/// // and on the other vehicle: Receive&lt;Envelope&lt;WindSample&gt;&gt;("wind in")
/// </code>
/// </example>
/// <typeparam name="T">A plain value.</typeparam>
public sealed class VehicleMessageRoute<T> : VehicleMessageRoute
    where T : struct
{
    private readonly IVehicleMessageCodec<T> _codec;

    /// <summary>Makes the route.</summary>
    /// <param name="codec">How it is written and read.</param>
    /// <param name="outgoingQueue">
    /// Queue of <see cref="Messages.Envelope{T}"/> that Communications receives: what is to be sent.
    /// </param>
    /// <param name="incomingQueue">
    /// Queue of <see cref="Messages.Envelope{T}"/>, of the manager that receives it: what other vehicles sent.
    /// </param>
    /// <exception cref="ArgumentException">
    /// A queue has no name, or the type or version of the codec is out of range.
    /// </exception>
    public VehicleMessageRoute(IVehicleMessageCodec<T> codec, string outgoingQueue, string incomingQueue)
        : base(
            (codec ?? throw new ArgumentNullException(nameof(codec))).MessageType, codec.Version, outgoingQueue,
            incomingQueue)
        => _codec = codec;

    internal override VehicleMessageChannel Open(CommunicationsManager manager)
        => new VehicleMessageChannel<T>(
            this, _codec, manager.ReceiveVehicleMessages<T>(OutgoingQueue, IsAcknowledged),
            manager.SendVehicleMessages<T>(IncomingQueue), manager.SendReports(ReportQueue));
}
