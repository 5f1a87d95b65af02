using Rabit.Core;

namespace Rabit.Diagnostics.Observing;

/// <summary>A message, and the reactor that has it.</summary>
internal sealed record EchoedMessage(RabitReactor Reactor, MessageObserver Observer);
