"""Pictures of an environment: arrays, or frames in a window of pygame."""

from __future__ import annotations


class Pictures:
    """What `render_mode` requests; the environment has a `kitchen` and `metadata`."""

    MODES = ("rgb_array", "human")

    def __init__(self, mode, size):
        if mode not in (None, *self.MODES):
            raise ValueError(f"render_mode = {mode!r}: there are None, 'rgb_array' and 'human'")
        self.mode, self.size = mode, tuple(size)
        self.window = self.clock = None

    def frame(self, env):
        """Returns the present picture, height × width × 3 bytes, in the mode rgb_array; else None."""
        return env.kitchen.render(self.size).copy() if self.mode == "rgb_array" else None

    def show(self, env):
        """Shows the present picture in a window, in the mode human."""
        if self.mode != "human":
            return
        try:
            import pygame
        except ImportError as error:
            raise ImportError("render_mode='human' needs pygame: pip install 'saute[gym]'") from error
        frame = env.kitchen.render(self.size)
        if self.window is None:
            pygame.display.init()
            pygame.display.set_caption("saute")
            self.window, self.clock = pygame.display.set_mode(self.size), pygame.time.Clock()
        pygame.event.pump()
        self.window.blit(pygame.surfarray.make_surface(frame.swapaxes(0, 1)), (0, 0))
        pygame.display.flip()
        self.clock.tick(env.metadata["render_fps"])

    def close(self):
        """Closes the window."""
        if self.window is not None:
            import pygame

            pygame.display.quit()
            self.window = None
